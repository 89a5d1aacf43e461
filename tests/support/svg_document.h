#pragma once

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace support {

/// An element of an SVG file, in the order of the file.
struct SvgElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;                                  ///< without its markup
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< px, of its coordinates in the drawing

  double number(const std::string& attribute) const { return std::stod(attributes.at(attribute)); }
  Eigen::Vector2d place(const std::string& x, const std::string& y) const {
    return origin + Eigen::Vector2d(number(x), number(y));
  }

  /// Points of a polyline or polygon, px in the drawing.
  std::vector<Eigen::Vector2d> points() const {
    std::istringstream numbers(attributes.at("points"));
    std::vector<Eigen::Vector2d> all;
    char comma = 0;
    for (Eigen::Vector2d point; numbers >> point.x() >> comma >> point.y();) {
      all.emplace_back(origin + point);
    }
    return all;
  }
};

/// The text without its markup; that all of it is markup that XML knows.
inline std::string unescaped(std::string text) {
  const std::vector<std::pair<std::string, char>> known{
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}};
  for (std::size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at + 1)) {
    bool is_known = false;
    for (const auto& [markup, character] : known) {
      if (text.compare(at, markup.size(), markup) == 0) {
        text.replace(at, markup.size(), 1, character);
        is_known = true;
        break;
      }
    }
    EXPECT_TRUE(is_known) << text.substr(at);
  }
  return text;
}

inline SvgElement svg_element(const std::string& tag, const Eigen::Vector2d& origin) {
  SvgElement element{tag.substr(0, tag.find_first_of(" /")), {}, "", origin};
  std::size_t at = element.name.size();
  for (std::size_t equals = tag.find("=\"", at); equals != std::string::npos;
       equals = tag.find("=\"", at)) {
    const std::size_t end = tag.find('"', equals + 2);
    const std::size_t start = tag.find_first_not_of(' ', at);
    const std::string name = tag.substr(start, equals - start);
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzB0123456789-"), std::string::npos)
        << tag;
    EXPECT_TRUE(
        element.attributes.emplace(name, unescaped(tag.substr(equals + 2, end - equals - 2)))
            .second)
        << "twice: " << tag;
    at = end + 1;
  }
  EXPECT_EQ(tag.find_first_not_of(" /", at), std::string::npos) << "no attributes: " << tag;
  constexpr const char* kTranslate = "translate(";
  const std::string& transform = element.attributes["transform"];
  if (transform.starts_with(kTranslate)) {
    std::istringstream numbers(transform.substr(std::string(kTranslate).size()));
    Eigen::Vector2d moved;
    numbers >> moved.x() >> moved.y();
    element.origin += moved;
  }
  return element;
}

/// The elements of an SVG; that it is well-formed.
inline std::vector<SvgElement> svg_elements(const std::string& svg) {
  std::vector<SvgElement> elements;
  std::vector<std::size_t> open;
  std::size_t at = 0;
  for (std::size_t start = svg.find('<'); start != std::string::npos; start = svg.find('<', at)) {
    if (!open.empty()) {
      elements[open.back()].text += unescaped(svg.substr(at, start - at));
    }
    const std::size_t end = svg.find('>', start);
    const std::string tag = svg.substr(start + 1, end - start - 1);
    at = end + 1;
    if (tag.front() == '/') {
      EXPECT_TRUE(!open.empty() && elements[open.back()].name == tag.substr(1)) << tag;
      open.pop_back();
      continue;
    }
    EXPECT_TRUE(elements.empty() || !open.empty()) << "one element holds all others";
    elements.push_back(
        svg_element(tag, open.empty() ? Eigen::Vector2d::Zero() : elements[open.back()].origin));
    if (tag.back() != '/') {
      open.push_back(elements.size() - 1);
    }
  }
  EXPECT_TRUE(open.empty()) << "all are closed";
  EXPECT_EQ(svg.substr(at), "\n");
  return elements;
}

/// The elements of a name.
inline std::vector<SvgElement> svg_elements(const std::string& svg, const std::string& name) {
  std::vector<SvgElement> elements;
  for (const SvgElement& element : svg_elements(svg)) {
    if (element.name == name) {
      elements.push_back(element);
    }
  }
  return elements;
}

/// The texts of an SVG.
inline std::vector<std::string> svg_texts(const std::string& svg) {
  std::vector<std::string> texts;
  for (const SvgElement& element : svg_elements(svg, "text")) {
    texts.push_back(element.text);
  }
  return texts;
}

}  // namespace support
