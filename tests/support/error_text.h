#pragma once

#include <string>

#include "vo/core/error.h"

namespace support {

/// The message of the Error that a call throws, "no error" when it throws none.
template <typename Call>
std::string error_text(Call call) {
  try {
    call();
  } catch (const vo::Error& error) {
    return error.what();
  }
  return "no error";
}

/// The kind of the Error that a call throws; the call must throw.
template <typename Call>
vo::ErrorKind error_kind(Call call) {
  try {
    call();
  } catch (const vo::Error& error) {
    return error.kind();
  }
  throw std::logic_error("no error");
}

}  // namespace support
