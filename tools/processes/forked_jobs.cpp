#include "tools/processes/forked_jobs.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <exception>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

struct RunningJob {
  std::size_t index = 0;
  pid_t process = -1;
  int results = -1;  ///< descriptor that the result is read from
  JobEnd end;
};

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    vo::require(written >= 0 || errno == EINTR, "the result cannot be passed on");
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

/// Does the job and ends this process.
[[noreturn]] void be_job(std::size_t index, const ForkedJobs& what, pid_t parent, int results) {
  constexpr int kThrew = 1;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) {
    ::_exit(kThrew);  // it ended before its end could be a signal
  }
  try {
    write_all(results, what.work(index));
  } catch (const std::exception&) {
    ::_exit(kThrew);
  }
  ::_exit(0);
}

RunningJob start_job(std::size_t index, const ForkedJobs& what) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    vo::fail_with("a pipe", "cannot be made", errno);
  }
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  const int error = errno;
  if (process == 0) {
    ::close(ends[0]);
    be_job(index, what, parent, ends[1]);
  }
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    vo::fail_with("a process", "cannot be started", error);
  }
  return {.index = index, .process = process, .results = ends[0], .end = {}};
}

/// The jobs that run; the destructor ends them.
class RunningJobs {
 public:
  RunningJobs() = default;
  ~RunningJobs() {
    signal_all(SIGTERM);
    constexpr int kLooks = 500;
    constexpr std::chrono::milliseconds kPause(10);
    for (int look = 0; look < kLooks && !reap_all(); ++look) {
      std::this_thread::sleep_for(kPause);
    }
    signal_all(SIGKILL);
    for (const RunningJob& job : jobs_) {
      ::waitpid(job.process, nullptr, 0);
    }
  }
  RunningJobs(const RunningJobs&) = delete;
  RunningJobs& operator=(const RunningJobs&) = delete;
  RunningJobs(RunningJobs&&) = delete;
  RunningJobs& operator=(RunningJobs&&) = delete;

  std::size_t size() const { return jobs_.size(); }

  void add(RunningJob job) { jobs_.push_back(std::move(job)); }

  /// Reads results for a while; returns the jobs that have ended.
  std::vector<RunningJob> wait() {
    constexpr int kPause = 100;  // ms
    std::vector<pollfd> events;
    for (const RunningJob& job : jobs_) {
      events.push_back({job.results, POLLIN, 0});
    }
    std::vector<RunningJob> ended;
    if (::poll(events.data(), events.size(), kPause) <= 0) {
      return ended;
    }
    for (std::size_t i = events.size(); i-- > 0;) {
      if (events[i].revents != 0 && !read_result(jobs_[i])) {
        ended.push_back(std::move(jobs_[i]));
        jobs_.erase(jobs_.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    return ended;
  }

 private:
  /// Returns false once the job has written all and ended.
  static bool read_result(RunningJob& job) {
    std::array<char, 65536> block{};
    const ssize_t count = ::read(job.results, block.data(), block.size());
    if (count > 0) {
      job.end.result.append(block.data(), static_cast<std::size_t>(count));
    }
    if (count != 0) {
      return true;
    }
    int status = 0;
    ::close(job.results);
    ::waitpid(job.process, &status, 0);
    job.end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    job.end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    return false;
  }

  void signal_all(int signal) const {
    for (const RunningJob& job : jobs_) {
      ::kill(job.process, signal);
    }
  }

  /// Forgets the jobs that have ended; returns whether none is left.
  bool reap_all() {
    std::erase_if(jobs_, [](const RunningJob& job) {
      return ::waitpid(job.process, nullptr, WNOHANG) == job.process;
    });
    return jobs_.empty();
  }

  std::vector<RunningJob> jobs_;
};

}  // namespace

void run_forked(std::size_t count, int jobs, const ForkedJobs& what,
                const vo::WaitObserver& waiting) {
  RunningJobs running;
  for (std::size_t next = 0; next < count || running.size() > 0;) {
    waiting();
    while (next < count && running.size() < static_cast<std::size_t>(jobs)) {
      running.add(start_job(next++, what));
    }
    for (RunningJob& job : running.wait()) {
      what.done(job.index, std::move(job.end));
    }
  }
}

}  // namespace tools
