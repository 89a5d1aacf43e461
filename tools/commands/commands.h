#pragma once

#include <CLI/CLI.hpp>

#include "tools/cli/session.h"

namespace tools {

/// Adds the subcommand `inspect` to the program. Every subcommand's callback does its work, prints
/// its result on stdout and sets the session's `status` where it is not 0; unusable input throws
/// vo::Error.
void add_inspect_command(CLI::App& program, Session& session);
void add_render_command(CLI::App& program, Session& session);
void add_convert_command(CLI::App& program, Session& session);
void add_record_command(CLI::App& program, Session& session);
void add_track_command(CLI::App& program, Session& session);
void add_evaluate_command(CLI::App& program, Session& session);
void add_run_command(CLI::App& program, Session& session);
void add_depth_command(CLI::App& program, Session& session);
void add_bench_command(CLI::App& program, Session& session);
void add_bench_render_command(CLI::App& program, Session& session);
void add_ablate_command(CLI::App& program, Session& session);
void add_path_command(CLI::App& program, Session& session);
void add_sensor_check_command(CLI::App& program, Session& session);
void add_train_edges_command(CLI::App& program, Session& session);
void add_test_command(CLI::App& program, Session& session);
void add_cache_command(CLI::App& program, Session& session);
void add_dataset_command(CLI::App& program, Session& session);
void add_submit_command(CLI::App& program, Session& session);
void add_compare_command(CLI::App& program, Session& session);
void add_budget_command(CLI::App& program, Session& session);
void add_basin_command(CLI::App& program, Session& session);
void add_sweep_command(CLI::App& program, Session& session);
void add_view_command(CLI::App& program, Session& session);
void add_completion_command(CLI::App& program, Session& session);
void add_manual_command(CLI::App& program, Session& session);

}  // namespace tools
