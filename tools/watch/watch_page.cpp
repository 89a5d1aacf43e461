#include "tools/watch/watch_page.h"

#include "vo/core/error.h"

namespace tools {

std::string watch_page(const ReportBundle& bundle) {
  const std::string head = vo::concat(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>edvo live</title>\n<style>",
      bundle.style, "</style>\n</head>\n<body>\n");
  if (!bundle.missing.empty()) {
    return vo::concat(head, "<p>This page shows nothing: ", bundle.missing,
                      "</p>\n</body>\n</html>\n");
  }
  return vo::concat(head,
                    "<noscript>This page needs JavaScript.</noscript>\n<div id=\"live\"></div>\n"
                    "<script>",
                    bundle.script, "</script>\n</body>\n</html>\n");
}

}  // namespace tools
