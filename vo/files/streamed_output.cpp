#include "vo/files/streamed_output.h"

#include "vo/core/error.h"
#include "vo/files/ranged_file.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

bool have_same_bytes(const fs::path& a, const fs::path& b) {
  constexpr std::uintmax_t kPart = 1 << 20;
  const RangedFile first(a);
  const RangedFile second(b);
  bool is_same = first.size() == second.size();
  for (std::uintmax_t at = 0; is_same && at < first.size(); at += kPart) {
    is_same = first.read(at, kPart) == second.read(at, kPart);
  }
  return is_same;
}

fs::path checked_place(const fs::path& path) {
  require_writable(path);
  require(!is_stream(path), path.string(), ": is a device or pipe, expected a file to write");
  return resolved_output(path);
}

}  // namespace

StreamedOutput::StreamedOutput(const fs::path& path, const OutputPolicy& policy,
                               const fs::path& extension)
    : given_(path),
      path_(checked_place(path)),
      policy_(policy),
      file_(path_, extension, policy.waiting) {}

fs::path StreamedOutput::open_by_name() {
  append({});
  return file_.partial_path();
}

void StreamedOutput::commit() {
  if (fs::is_regular_file(path_)) {
    if (have_same_bytes(path_, file_.partial_path())) {
      return;
    }
    if (policy_.existing == ExistingOutput::keep) {
      fail_to_replace(given_);
    }
  }
  file_.commit(policy_.durability);
}

}  // namespace vo
