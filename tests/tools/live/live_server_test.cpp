#include "tools/live/live_server.h"

#include <csignal>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/http_request.h"
#include "tools/live/event_feed.h"
#include "tools/live/pause_gate.h"
#include "vo/core/error.h"

namespace {

using support::answer_to;
using support::request_text;
using support::status_of;
using testing::EndsWith;
using testing::HasSubstr;

class LiveServer : public testing::Test {
 protected:
  void SetUp() override {
    try {
      server_ = std::make_unique<tools::LiveServer>(
          tools::LiveContent{.page = "the page", .feed = &feed_, .gate = &gate_},
          tools::LivePort{});
    } catch (const vo::Error& error) {
      if (error.kind() == vo::ErrorKind::usage) {
        GTEST_SKIP() << error.what();
      }
      throw;
    }
  }

  support::LocalUrl url() const { return support::LocalUrl(server_->url()); }

  std::string request(const std::string& method, const std::string& path,
                      const std::string& headers = "") const {
    return request_text(method, path + url().query, "Host: " + url().host() + "\r\n" + headers);
  }

  std::string ask(const std::string& method, const std::string& path,
                  const std::string& headers = "") const {
    return answer_to(url().port, request(method, path, headers));
  }

  tools::EventFeed feed_;
  tools::PauseGate gate_;
  std::unique_ptr<tools::LiveServer> server_;
};

TEST_F(LiveServer, GivesThePageToWhoKnowsTheUrl) {
  const std::string answer = ask("GET", "/");
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_THAT(answer, EndsWith("\r\n\r\nthe page"));
  EXPECT_THAT(answer, HasSubstr("default-src 'none'"));
  EXPECT_THAT(answer, HasSubstr("Referrer-Policy: no-referrer"));
  EXPECT_THAT(answer, HasSubstr("Cache-Control: no-store"));
}

TEST_F(LiveServer, SpendsNoTimeOnCompression) {
  const std::string answer = ask("GET", "/", "Accept-Encoding: gzip, deflate, br, zstd\r\n");
  EXPECT_THAT(answer, EndsWith("\r\n\r\nthe page"));
}

TEST_F(LiveServer, RefusesEverythingWithoutTheToken) {
  const std::string host = "Host: " + url().host() + "\r\n";
  for (const char* path :
       {"/", "/events", "/none", "/?token=", "/?token=0123", "/events?token=1"}) {
    EXPECT_EQ(status_of(answer_to(url().port, request_text("GET", path, host))), 403) << path;
  }
  for (const char* path : {"/pause", "/step?token=wrong"}) {
    EXPECT_EQ(status_of(answer_to(url().port, request_text("POST", path, host))), 403) << path;
  }
  EXPECT_FALSE(gate_.is_paused());
}

TEST_F(LiveServer, RefusesAnotherHostAndAnotherOrigin) {
  const std::string other = request_text("GET", "/" + url().query, "Host: evil.example\r\n");
  EXPECT_EQ(status_of(answer_to(url().port, other)), 403);
  EXPECT_EQ(status_of(answer_to(url().port, request_text("GET", "/" + url().query, ""))), 403);
  EXPECT_EQ(status_of(ask("GET", "/events", "Origin: http://evil.example\r\n")), 403);
  EXPECT_EQ(status_of(ask("POST", "/pause", "Origin: null\r\n")), 403);
  EXPECT_FALSE(gate_.is_paused());
  EXPECT_EQ(status_of(ask("POST", "/pause", "Origin: http://" + url().host() + "\r\n")), 200);
  EXPECT_TRUE(gate_.is_paused());
}

TEST_F(LiveServer, TakesNothingButTheMovesOfTheGate) {
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "OPTIONS"}) {
    for (const char* path : {"/", "/events", "/other"}) {
      EXPECT_EQ(status_of(ask(method, path)), 405) << method << path;
    }
  }
  EXPECT_EQ(status_of(ask("GET", "/pause")), 404);
  EXPECT_EQ(status_of(ask("GET", "/../../etc/passwd")), 404);
  EXPECT_FALSE(gate_.is_paused());
  EXPECT_EQ(status_of(ask("POST", "/step")), 200);
  EXPECT_TRUE(gate_.is_paused());
  gate_.pass({});
  EXPECT_EQ(status_of(ask("POST", "/resume")), 200);
  EXPECT_FALSE(gate_.is_paused());
}

TEST_F(LiveServer, TellsTheEventsAsTheyComeAndEndsWithTheRun) {
  feed_.keep("frame", "{\"n\":1}");
  const support::Connection viewer(url().port);
  viewer.send(request("GET", "/events"));
  EXPECT_THAT(viewer.read_until("{\"n\":1}"), HasSubstr("text/event-stream"));
  feed_.keep("frame", "{\"n\":2}");
  EXPECT_THAT(viewer.read_until("{\"n\":2}"), HasSubstr("event: frame\ndata: {\"n\":2}\n\n"));
  feed_.keep("end", "{}");
  server_.reset();
  EXPECT_THAT(viewer.read_until(""), HasSubstr("event: end\ndata: {}\n\n"));
}

TEST_F(LiveServer, IsNotHeldUpByAViewerWhoNeverReads) {
  const support::Connection idle(url().port);
  idle.send(request("GET", "/events"));
  const support::Connection reading(url().port);
  reading.send(request("GET", "/events"));
  const std::string event(4000, 'x');
  constexpr int kEvents = 5000;  // 20 MB: no socket's memory holds them
  for (int i = 0; i < kEvents; ++i) {
    feed_.keep("frame", event);
  }
  feed_.keep("end", "last");
  EXPECT_GT(reading.read_until("last").size(), kEvents * event.size());
}

TEST_F(LiveServer, OpensTheGateWhenTheLastViewerGoes) {
  {
    const support::Connection viewer(url().port);
    viewer.send(request("GET", "/events"));
    feed_.keep("frame", "1");
    viewer.read_until("event: frame");
    EXPECT_EQ(feed_.viewers(), 1U);
    gate_.pause();
  }
  gate_.pass({});
  EXPECT_FALSE(gate_.is_paused());
}

TEST_F(LiveServer, LeavesSignalsAsTheyWere) {
  struct sigaction now {};
  ::sigaction(SIGPIPE, nullptr, &now);
  EXPECT_EQ(now.sa_handler, SIG_DFL);
}

TEST_F(LiveServer, SaysThatItsPortIsTaken) {
  const int port = url().port;
  EXPECT_THAT(support::error_text([&] {
                tools::LiveServer({.page = ""}, {port, "--port "});
              }),
              HasSubstr("--port " + std::to_string(port) + ": the port is taken"));
}

TEST_F(LiveServer, ServesAPageWithoutARun) {
  const tools::LiveServer alone({.page = "done"}, {});
  const support::LocalUrl url(alone.url());
  const std::string host = "Host: " + url.host() + "\r\n";
  EXPECT_THAT(answer_to(url.port, request_text("GET", "/" + url.query, host)), EndsWith("done"));
  EXPECT_EQ(status_of(answer_to(url.port, request_text("GET", "/events" + url.query, host))), 404);
  EXPECT_EQ(status_of(answer_to(url.port, request_text("POST", "/pause" + url.query, host))), 405);
}

}  // namespace
