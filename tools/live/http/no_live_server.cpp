#include "tools/live/live_server.h"
#include "vo/core/error.h"

namespace tools {

struct LiveServer::Serving {};

LiveServer::LiveServer(const LiveContent& /*content*/, const LivePort& /*port*/) {
  vo::fail_as(vo::ErrorKind::usage,
              "the program was built without an HTTP server, expected one built where "
              "libcpp-httplib-dev is installed");
}

LiveServer::~LiveServer() = default;

}  // namespace tools
