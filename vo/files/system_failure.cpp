#include "vo/files/system_failure.h"

#include <system_error>

namespace vo {

ErrorKind kind_of_failure(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
    case EMFILE:
    case ENFILE:
    case ENOMEM:
    case EAGAIN:
    case EINTR:
    case EIO:
    case ENOLCK:
    case EBUSY:
    case ESTALE:
      return ErrorKind::temporary;
    default:
      return ErrorKind::input;
  }
}

void fail_with(const std::filesystem::path& path, std::string_view what, int error) {
  fail_as(kind_of_failure(error), path.string(), ": ", what, ": ",
          std::generic_category().message(error));
}

}  // namespace vo
