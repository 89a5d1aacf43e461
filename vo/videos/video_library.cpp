#include "vo/videos/video_library.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

#include <dlfcn.h>
#include <sysexits.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/core/version.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLibraryName = "libedvo_video.so";

/// Returns where the library may be: beside a program that was built and not installed; where it
/// is installed, seen from the program and from the library that holds this function.
std::vector<fs::path> library_places() {
  std::vector<fs::path> places;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  if (!program.empty()) {
    places.push_back(program / kLibraryName);
    places.push_back(program / EDVO_LIBRARIES_FROM_PROGRAMS / "edvo" / kLibraryName);
  }
  Dl_info own{};
  if (::dladdr(kLibraryName, &own) != 0 && own.dli_fname != nullptr) {
    places.push_back(fs::path(own.dli_fname).parent_path() / "edvo" / kLibraryName);
  }
  return places;
}

/// The library, or why there is none.
struct LoadedLibrary {
  const VideoLibrary* library = nullptr;
  std::string failure;
  ErrorKind kind = ErrorKind::input;  ///< of the failure
};

/// Returns the kind of failure that the dynamic linker tells of. It keeps no errno: of glibc's
/// messages those that speak of memory and open files are for want of them.
ErrorKind kind_of_linking_failure(std::string_view reason) {
  constexpr std::array<std::string_view, 5> kShortages = {"failed to map segment",
                                                          "cannot map zero-fill", "annot allocate",
                                                          "cannot create", "Too many open files"};
  const bool is_shortage = std::any_of(
      kShortages.begin(), kShortages.end(),
      [&](std::string_view shortage) { return reason.find(shortage) != std::string_view::npos; });
  return is_shortage ? ErrorKind::temporary : ErrorKind::input;
}

/// Tells OpenCV, which reads it when it is loaded, that FFmpeg is not to write on stderr, and that
/// a camera without images is given up after a second, so that it can be left.
void silence_library() {
  // NOLINTBEGIN(concurrency-mt-unsafe): once, when the library is not there yet
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  ::setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "1", 0);
  // NOLINTEND(concurrency-mt-unsafe)
}

/// Ends the process as a shortage does elsewhere where a library aborts while it is loaded. Those
/// of OpenCV and FFmpeg do so in their constructors, where nobody can catch what they throw, for
/// want of memory (GDCM) or of a file (libgcrypt).
class AbortsWhileLoading {
 public:
  AbortsWhileLoading() {
    struct sigaction end {};
    end.sa_handler = end_process;
    ::sigaction(SIGABRT, &end, &before_);
  }
  ~AbortsWhileLoading() { ::sigaction(SIGABRT, &before_, nullptr); }
  AbortsWhileLoading(const AbortsWhileLoading&) = delete;
  AbortsWhileLoading& operator=(const AbortsWhileLoading&) = delete;
  AbortsWhileLoading(AbortsWhileLoading&&) = delete;
  AbortsWhileLoading& operator=(AbortsWhileLoading&&) = delete;

 private:
  static void end_process(int /*signal*/) {
    constexpr std::string_view kLine =
        "edvo: OpenCV's videoio cannot be loaded: a library that it needs gave up, as for want of "
        "memory or of open files\n";
    const ssize_t ignored = ::write(STDERR_FILENO, kLine.data(), kLine.size());
    static_cast<void>(ignored);
    ::_exit(EX_TEMPFAIL);
  }

  struct sigaction before_ {};
};

LoadedLibrary load(const fs::path& file) {
  silence_library();
  const AbortsWhileLoading aborts;
  // It stays loaded: FFmpeg's threads and what they leave behind outlive every video.
  void* handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* reason = ::dlerror();  // NOLINT(concurrency-mt-unsafe): the thread's own in glibc
    return {nullptr, concat("OpenCV's videoio cannot be loaded: ", reason),
            kind_of_linking_failure(reason)};
  }
  const auto entry = reinterpret_cast<VideoLibraryEntry>(::dlsym(handle, kVideoLibraryEntry));
  const VideoLibrary* library = entry == nullptr ? nullptr : entry(version());
  return {library, library == nullptr
                       ? concat(file.string(), " is not of this version, expected ", version())
                       : ""};
}

LoadedLibrary load_first() {
  for (const fs::path& place : library_places()) {
    std::error_code ignored;
    if (fs::exists(place, ignored)) {
      return load(place);
    }
  }
  return {nullptr, concat("this program was built without OpenCV's videoio, expected ",
                          kLibraryName, " of a build with libopencv-videoio-dev")};
}

}  // namespace

const VideoLibrary& video_library(const std::string& place) {
  static const LoadedLibrary loaded = load_first();
  if (loaded.library == nullptr) {
    fail_as(loaded.kind, place, ": ", loaded.failure);
  }
  return *loaded.library;
}

}  // namespace vo
