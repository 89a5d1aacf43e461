#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "tools/train_edges/comparison_picture.h"
#include "tools/train_edges/detector_sweep.h"
#include "tools/train_edges/forest_trainer.h"
#include "vo/archives/gzip.h"
#include "vo/core/error.h"
#include "vo/image_files/png.h"
#include "vo/structured_forest/structured_forest_file.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTrainEdgesHelp =
    "Learns a structured forest (Dollar & Zitnick, ICCV 2013) from rendered views, whose edges "
    "are\n"
    "known exactly: steps of depth, creases, changes of colour, borders of shadows. Writes the\n"
    "model format of OpenCV's ximgproc::createStructuredEdgeDetection; `edvo track` takes it with\n"
    "--set edges.detector=structured_forest --set edges.forest_model=FILE.\n"
    "With --evaluate, instead: precision and recall of a model and of Canny, LoG and Sobel "
    "against\n"
    "the exact edges, within 2 px, each detector at the threshold with the best F over all views.";

constexpr const char* kTrainEdgesExamples =
    "Examples:\n"
    "  edvo train-edges assets/room/room.gltf --out forest.yml.gz\n"
    "  edvo train-edges a.gltf b.gltf --views 300 --seed 7 --tree.max-leaves 2000 \\\n"
    "       --out forest.yml.gz\n"
    "  edvo train-edges --evaluate forest.yml.gz unseen.gltf --views 20 --width 640 --height 480 "
    "\\\n"
    "       --picture comparison.png";

struct TrainArguments {
  CommonOptions common;
  std::vector<std::string> scenes;
  std::string out;
  std::string evaluated_model;
  std::string picture;
  ViewOptions views;
  ForestTrainingOptions training;
};

std::vector<LabelledView> render_views(const TrainArguments& arguments) {
  std::vector<LabelledView> all;
  for (const std::string& scene : arguments.scenes) {
    ProgressBar bar("rendering " + scene, arguments.common.verbosity());
    bar.announce();
    for (LabelledView& view : render_labelled_views(scene, arguments.views, bar.callback())) {
      all.push_back(std::move(view));
    }
  }
  return all;
}

void train(const TrainArguments& arguments, const Session& session) {
  vo::require_writable(arguments.out);
  const std::vector<LabelledView> views = render_views(arguments);
  ProgressBar bar("training", arguments.common.verbosity());
  bar.announce();
  const vo::StructuredForest forest =
      train_forest(views, arguments.training, arguments.views.seed, bar.callback());
  bar.erase();
  const std::string text = structured_forest_yaml(forest);
  const bool is_compressed = arguments.out.ends_with(".gz");
  const std::string bytes = is_compressed ? vo::gzip(text) : text;
  vo::write_file(arguments.out, bytes, arguments.common.output_policy());
  if (arguments.common.json) {
    const Json result = {{"model", arguments.out},
                         {"bytes", bytes.size()},
                         {"views", views.size()},
                         {"trees", forest.parameters().trees},
                         {"nodes", forest.nodes().children.size()}};
    std::cout << json_text(json_document({"train_edges"}, result));
  } else {
    speech_beside(session, {arguments.out}).stream
        << arguments.out << ": " << forest.parameters().trees << " trees, "
        << forest.nodes().children.size() << " nodes, " << bytes.size() << " bytes, from "
        << views.size() << " views\n";
  }
}

Json as_json(const SweepPoint& point) {
  Json json = {{"threshold", point.threshold},
               {"precision", point.score.precision()},
               {"recall", point.score.recall()},
               {"f_measure", point.score.f_measure()}};
  for (const auto& [cause, name] : enum_names(synth::EdgeCause{})) {
    json[std::string("recall_") + name] = point.score.recall_of(cause);
  }
  return json;
}

Json as_json(const std::vector<DetectorCurve>& curves, std::size_t views) {
  Json json = {{"views", views}, {"tolerance_px", kEdgeTolerance}, {"detectors", Json::array()}};
  for (const DetectorCurve& curve : curves) {
    Json points = Json::array();
    for (const SweepPoint& point : curve.points) {
      points.push_back(as_json(point));
    }
    json["detectors"].push_back({{"detector", vo::to_string(curve.detector)},
                                 {"swept", curve.threshold_name},
                                 {"best", as_json(curve.best())},
                                 {"curve", points}});
  }
  return json;
}

void print_table(const std::vector<DetectorCurve>& curves, std::size_t views, std::ostream& out) {
  out << views << " views, tolerance " << kEdgeTolerance << " px; recall also by cause\n";
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(), "%-18s %-22s %9s %7s %7s   %7s %7s %7s %7s\n", "detector",
                "best threshold", "precision", "recall", "F", "depth", "crease", "albedo",
                "shadow");
  out << line.data();
  for (const DetectorCurve& curve : curves) {
    const SweepPoint& best = curve.best();
    const EdgeScore& score = best.score;
    std::array<char, 64> threshold{};
    std::snprintf(threshold.data(), threshold.size(), "%s %.4g", curve.threshold_name.c_str(),
                  best.threshold);
    std::snprintf(
        line.data(), line.size(), "%-18s %-22s %9.3f %7.3f %7.3f   %7.3f %7.3f %7.3f %7.3f\n",
        vo::to_string(curve.detector).data(), threshold.data(), score.precision(), score.recall(),
        score.f_measure(), score.recall_of(synth::EdgeCause::depth),
        score.recall_of(synth::EdgeCause::crease), score.recall_of(synth::EdgeCause::albedo),
        score.recall_of(synth::EdgeCause::shadow));
    out << line.data();
  }
}

void evaluate(const TrainArguments& arguments, const Session& session) {
  if (!arguments.picture.empty()) {
    vo::require_writable(arguments.picture);
  }
  const vo::StructuredForest forest = vo::read_structured_forest(arguments.evaluated_model);
  const std::vector<LabelledView> views = render_views(arguments);
  ProgressBar bar("evaluating", arguments.common.verbosity());
  bar.announce();
  const std::vector<DetectorCurve> curves = sweep_detectors(forest, views, bar.callback());
  bar.erase();
  if (!arguments.picture.empty()) {
    const auto first_of_scene = static_cast<std::size_t>(arguments.views.views);
    vo::write_file(arguments.picture,
                   vo::encode_png(draw_comparison(views, first_of_scene, forest, curves)),
                   arguments.common.output_policy());
  }
  if (arguments.common.json) {
    std::cout << json_text(json_document({"edge_detectors"}, as_json(curves, views.size())));
  } else {
    print_table(curves, views.size(), speech_beside(session, {arguments.picture}).stream);
  }
}

void run(const TrainArguments& arguments, const Session& session) {
  const auto limit = arguments.common.limit_threads();
  const bool is_evaluation = !arguments.evaluated_model.empty();
  check_usage([&] {
    arguments.views.validate();
    arguments.training.validate();
    vo::require(is_evaluation != !arguments.out.empty(),
                "train-edges: expected either --out MODEL.yml.gz or --evaluate MODEL.yml.gz");
    vo::require(is_evaluation || arguments.picture.empty(), "--picture: expected --evaluate too");
  });
  if (is_evaluation) {
    evaluate(arguments, session);
  } else {
    train(arguments, session);
  }
}

}  // namespace

void add_train_edges_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("train-edges", kTrainEdgesHelp);
  const auto arguments = std::make_shared<TrainArguments>();
  command.footer(kTrainEdgesExamples);
  command.add_option("SCENE", arguments->scenes, "glTF 2.0 files, .gltf or .glb")->required();
  command.add_option("--out", arguments->out, "model to write, .yml or .yml.gz");
  command.add_option("--evaluate", arguments->evaluated_model, "model to judge on the scenes");
  command.add_option("--picture", arguments->picture,
                     "PNG to write with --evaluate: image, exact edges, forest, Canny");
  add_field_options(command, vo::fields_of(arguments->views), "Views");
  add_field_options(command, vo::fields_of(arguments->training), "Training");
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"SCENE", "--evaluate"}, .outputs = {"--out", "--picture"}});
  command.callback([arguments, &session] { run(*arguments, session); });
}

}  // namespace tools
