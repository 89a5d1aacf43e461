#include "tools/plot/plot.h"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/svg_document.h"

namespace {

using support::svg_elements;
using support::svg_texts;
using support::SvgElement;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;
using tools::AxisScale;
using tools::PlotMark;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 0.1;           // px, of two coordinates with one decimal
constexpr const char* kLowest = "#0d0887";  // of the colours, and their middle and end
constexpr const char* kMiddle = "#b12a90";
constexpr const char* kHighest = "#fca636";

/// The corners of a text's box, as narrow as a narrow font has it.
std::vector<Eigen::Vector2d> box_of(const SvgElement& text) {
  constexpr double kCharacter = 6;  // px
  constexpr double kHeight = 9;     // px, above the baseline
  const double width = kCharacter * static_cast<double>(text.text.size());
  const std::string& anchor = text.attributes.at("text-anchor");
  const double left = anchor == "start" ? 0 : anchor == "end" ? -width : -width / 2;
  const std::string& transform = text.attributes.at("transform");
  const double degrees = std::stod(transform.substr(transform.find("rotate(") + 7));
  const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
  std::vector<Eigen::Vector2d> corners;
  for (const auto& [x, y] : {std::pair{left, 0.0}, std::pair{left + width, 0.0},
                             std::pair{left + width, -kHeight}, std::pair{left, -kHeight}}) {
    corners.emplace_back(text.origin + turn * Eigen::Vector2d(x, y));
  }
  return corners;
}

/// Returns whether a direction of the first box's sides separates the boxes.
bool is_separated(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b) {
  for (const Eigen::Vector2d& along :
       {Eigen::Vector2d(a[1] - a[0]), Eigen::Vector2d(a[3] - a[0])}) {
    tools::Range of_a{along.dot(a[0]), along.dot(a[0])};
    tools::Range of_b{along.dot(b[0]), along.dot(b[0])};
    for (std::size_t i = 1; i < a.size(); ++i) {
      of_a.include(along.dot(a[i]));
      of_b.include(along.dot(b[i]));
    }
    if (of_a.high < of_b.low || of_b.high < of_a.low) {
      return true;
    }
  }
  return false;
}

/// That texts neither overlap nor leave the drawing.
void expect_legible(const std::string& svg) {
  const std::vector<SvgElement> texts = svg_elements(svg, "text");
  const SvgElement document = svg_elements(svg, "svg").at(0);
  const Eigen::AlignedBox2d drawing(Eigen::Vector2d(0, 0), document.place("width", "height"));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (const Eigen::Vector2d& corner : box_of(texts[i])) {
      EXPECT_TRUE(drawing.contains(corner)) << texts[i].text << " at " << corner.transpose();
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(is_separated(box_of(texts[i]), box_of(texts[j])) ||
                  is_separated(box_of(texts[j]), box_of(texts[i])))
          << texts[i].text << " overlaps " << texts[j].text;
    }
  }
}

std::size_t count(const std::string& svg, const std::string& name) {
  return svg_elements(svg, name).size();
}

TEST(Plot, DrawsEveryFinitePointAndNamesEachSeriesOnce) {
  const tools::PlotSeries series{
      "edges", 0, PlotMark::line_and_points, {{1, 1}, {2, kNan}, {3, 2}}};
  const tools::PlotPanel panel{
      .x = {.title = "points"}, .y = {.title = "error, mm"}, .series = {series}};
  const std::string svg = tools::draw_plot("Two panels", {panel, panel});
  EXPECT_EQ(count(svg, "circle"), 2U * 2 + 1) << "and one in the legend";
  EXPECT_EQ(count(svg, "polyline"), 2U + 1) << "and one in the legend";
  EXPECT_THAT(svg_texts(svg), Contains("edges").Times(1));
  EXPECT_THAT(svg_texts(svg), Contains("error, mm").Times(2));
}

TEST(Plot, BarsStandOnZeroAndHaveCategories) {
  const tools::PlotPanel panel{
      .x = {.categories = {"Canny", "Sobel"}},
      .y = {.title = "RPE, mm/s"},
      .series = {{"frame to frame", 0, PlotMark::bar, {{0, 20}, {1, -30}}}}};
  const std::string svg = tools::draw_plot("Detectors", {panel});
  const std::vector<SvgElement> bars = svg_elements(svg, "rect");
  ASSERT_EQ(bars.size(), 1U + 1 + 2) << "background, legend, bars";
  EXPECT_NEAR(bars[2].number("y") + bars[2].number("height"), bars[3].number("y"), kRounding);
  EXPECT_NEAR(bars[2].number("height") / bars[3].number("height"), 20.0 / 30, 0.002);
  EXPECT_THAT(svg_texts(svg), Contains("Sobel"));
  EXPECT_THAT(svg_texts(svg), Contains("0"));
}

TEST(Plot, EqualScalesDrawASquareAsASquare) {
  tools::PlotPanel panel{.series = {{"square", 0, PlotMark::line, {{2, 5}, {3, 5}, {3, 6}, {2, 6}}},
                                    {"wide", 1, PlotMark::line, {{0, 5}, {9, 5}}}}};
  const auto sides = [&] {
    const auto corners =
        svg_elements(tools::draw_plot("Square", {panel}), "polyline").at(2).points();
    return std::pair{corners[1].x() - corners[0].x(), corners[1].y() - corners[2].y()};
  };
  EXPECT_GT(sides().second, 2 * sides().first) << "by default the axes are filled";
  panel.has_equal_scales = true;
  EXPECT_NEAR(sides().first, sides().second, kRounding);
  EXPECT_GT(sides().first, panel.width / 12) << "and no smaller than needed";
  panel.series[1].points = {{2, 0}, {2, 9}};
  EXPECT_NEAR(sides().first, sides().second, kRounding);
}

TEST(Plot, AColouredLineHasTheColourOfEachValue) {
  tools::PlotPanel panel{
      .series = {{"", 0, PlotMark::coloured_line, {}}},
      .colours = tools::PlotColours{"error, mm", {0.1, 1000}, AxisScale::logarithmic}};
  for (const double value : {7.0, 0.1, 10.0, 1e9, kNan}) {
    const auto x = static_cast<double>(panel.series[0].points.size());
    panel.series[0].points.push_back({.x = x, .y = x, .value = value});
  }
  const std::string svg = tools::draw_plot("Coloured", {panel});
  std::vector<std::string> strokes;
  for (const SvgElement& piece : svg_elements(svg, "line")) {
    if (piece.attributes.contains("stroke")) {
      strokes.push_back(piece.attributes.at("stroke"));
    }
  }
  EXPECT_THAT(strokes, ElementsAre(kLowest, kMiddle, kHighest, "#999999"))
      << "lowest, in the middle, beyond, unknown";
  EXPECT_THAT(svg_texts(svg), Contains("error, mm"));
  expect_legible(svg);
}

TEST(Plot, TheColourBarRunsFromLowToHigh) {
  const tools::PlotPanel panel{.colours = tools::PlotColours{"error, mm", {0, 3}}};
  const std::string svg = tools::draw_plot("Bar", {panel});
  const std::vector<SvgElement> steps = svg_elements(svg, "rect");
  ASSERT_GT(steps.size(), 20U);
  const double low = steps[1].place("x", "y").y() + steps[1].number("height");
  const double high = steps.back().place("x", "y").y();
  EXPECT_NEAR(low - high, panel.height, kRounding);
  EXPECT_EQ(steps[1].attributes.at("fill").substr(0, 2), "#0") << "dark";
  EXPECT_EQ(steps.back().attributes.at("fill").substr(0, 2), "#f") << "light";
  const double left = steps[1].place("x", "y").x();
  std::map<std::string, double> labels;
  for (const SvgElement& text : svg_elements(svg, "text")) {
    if (text.origin.x() > left) {
      labels[text.text] = text.origin.y();
    }
  }
  EXPECT_NEAR(labels.at("0") - labels.at("3"), panel.height, kRounding);
}

TEST(Plot, CellsHaveColoursAndNumbers) {
  const tools::PlotPanel panel{.x = {.categories = {"10", "20"}},
                               .y = {.categories = {"1", "2"}},
                               .cells = {.values = {{0, 100}, {kNan, 50}}, .decimals = 1},
                               .colours = tools::PlotColours{"converged, %", {0, 100}}};
  const std::string svg = tools::draw_plot("Map", {panel});
  std::vector<std::string> fills;
  for (const SvgElement& cell : svg_elements(svg, "rect")) {
    if (cell.attributes.at("height") == "127.0") {
      fills.push_back(cell.attributes.at("fill"));
    }
  }
  EXPECT_THAT(fills, ElementsAre(kLowest, kHighest, kMiddle));
  for (const SvgElement& text : svg_elements(svg, "text")) {
    EXPECT_EQ(text.attributes.contains("fill"), text.text == "0.0" || text.text == "50.0")
        << text.text;
  }
  EXPECT_THAT(svg_texts(svg), Contains("100.0"));
  EXPECT_THAT(svg_texts(svg), Not(Contains("-")));
  expect_legible(svg);
}

TEST(Plot, StackedPanelsShareTheirLeftEnd) {
  tools::PlotPanel panel{.series = {{"", 0, PlotMark::line, {{0, 1}, {1, 2}}}}};
  tools::PlotPanel wide = panel;
  wide.y.include = {0, 1e8};
  const std::string svg = tools::draw_plot("Stack", {panel, wide}, tools::PlotLayout::stacked);
  const std::vector<SvgElement> lines = svg_elements(svg, "polyline");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].origin.x(), lines[1].origin.x());
  EXPECT_GT(lines[1].origin.y(), lines[0].origin.y() + panel.height);
  expect_legible(svg);
}

TEST(Plot, TextsOfAnyLengthAreEscapedAndNeitherOverlapNorLeaveTheDrawing) {
  const std::string odd = "a <b> & \"c\" d";
  tools::PlotPanel bars{.x = {.title = odd + " along the horizontal axis, in a unit of its own, %"},
                        .y = {.title = odd + " along the vertical axis, in a unit of its own, mm"}};
  for (const char* name : {"alone", "share of what the whole costs", "others, not named"}) {
    bars.series.push_back({odd + name, static_cast<int>(bars.series.size()), PlotMark::bar, {}});
  }
  for (int i = 0; i < 12; ++i) {
    bars.x.categories.push_back(i % 3 == 0 ? "vignetting+exposure+motion_blur+" + odd : "noise");
    bars.series[0].points.push_back({static_cast<double>(i), 1e6 * i});
  }
  const tools::PlotPanel fine{
      .x = {.title = odd},
      .y = {.title = odd, .scale = AxisScale::logarithmic},
      .series = {{odd, 3, PlotMark::line_and_points, {{0.00001, 1e-9}, {0.00007, 1e9}}}}};
  const std::string title = odd + std::string(200, 'm');
  const std::string svg = tools::draw_plot(title, {bars, fine});
  EXPECT_THAT(svg_texts(svg), Contains(title));
  EXPECT_THAT(svg_texts(svg), Contains(odd).Times(3));
  expect_legible(svg);
  expect_legible(tools::draw_plot(title, {bars, fine, fine}, tools::PlotLayout::stacked));
  expect_legible(tools::draw_plot(title, {}));
}

}  // namespace
