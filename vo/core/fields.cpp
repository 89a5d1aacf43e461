#include "vo/core/fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

#include "vo/core/error.h"

namespace vo {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

template <typename Number>
bool parse_all(std::string_view text, Number& number) {
  text = trimmed(text);
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
    }
  }
  return row.back();
}

std::vector<double> split_reals(std::string_view text) {
  std::vector<double> values;
  std::string_view rest = text;
  while (!trimmed(rest).empty()) {
    const auto comma = rest.find(',');
    double value = 0;
    require(parse_all(rest.substr(0, comma), value) && std::isfinite(value),
            "expected numbers with commas between, got '", text, "'");
    values.push_back(value);
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
  }
  return values;
}

/// The renamed parts of keys: the old spelling and the current one.
constexpr std::array<std::pair<std::string_view, std::string_view>, 1> kRenamed = {
    {{"map.anchor.", "map.host."}}};

std::string join_point(const Eigen::Vector3d& point) {
  return format_real(point.x()) + "," + format_real(point.y()) + "," + format_real(point.z());
}

}  // namespace

std::string format_real(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

double parse_real(std::string_view text) {
  double value = 0;
  require(parse_all(text, value) && std::isfinite(value), "expected a number, got '", text, "'");
  return value;
}

std::int64_t parse_integer(std::string_view text) {
  std::int64_t value = 0;
  require(parse_all(text, value), "expected a whole number, got '", text, "'");
  return value;
}

bool parse_boolean(std::string_view text) {
  require(text == "true" || text == "false", "expected true or false, got '", text, "'");
  return text == "true";
}

std::vector<double> parse_reals(std::string_view text, std::size_t count) {
  std::vector<double> values = split_reals(text);
  require(values.size() == count, "expected ", count, " numbers with commas between, got '", text,
          "'");
  return values;
}

std::vector<Eigen::Vector3d> parse_points(std::string_view text) {
  const std::vector<double> values = split_reals(text);
  require(values.size() % 3 == 0, "expected points of three numbers each, got ", values.size(),
          " numbers");
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < values.size(); i += 3) {
    points.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
  return points;
}

std::size_t parse_choice(std::string_view text, const std::vector<std::string_view>& names) {
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) {
    std::string list;
    for (const std::string_view name : names) {
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
    fail("expected one of ", list, ", got '", text, "'");
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::string nearest_key(std::string_view key, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t nearest_distance = 1 + std::max<std::size_t>(2, key.size() / 2);
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(key, candidate);
    if (distance < nearest_distance) {
      nearest_distance = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

void FieldCollector::add(const char* name, const std::string& help, FieldType type,
                         std::function<std::string()> get,
                         std::function<void(std::string_view)> set) {
  fields_.push_back({prefix_ + name, help, type, std::move(get), std::move(set)});
}

void FieldCollector::operator()(const char* name, bool& value, const char* help) {
  add(
      name, help, FieldType::boolean, [&value] { return value ? "true" : "false"; },
      [&value](std::string_view text) { value = parse_boolean(text); });
}

void FieldCollector::operator()(const char* name, int& value, const char* help) {
  add(
      name, help, FieldType::integer, [&value] { return std::to_string(value); },
      [&value](std::string_view text) {
        const std::int64_t number = parse_integer(text);
        require(std::in_range<int>(number), "expected a whole number below 2^31, got '", text, "'");
        value = static_cast<int>(number);
      });
}

void FieldCollector::operator()(const char* name, std::uint64_t& value, const char* help) {
  add(
      name, help, FieldType::integer, [&value] { return std::to_string(value); },
      [&value](std::string_view text) {
        const std::int64_t number = parse_integer(text);
        require(number >= 0, "expected a whole number from 0, got '", text, "'");
        value = static_cast<std::uint64_t>(number);
      });
}

void FieldCollector::operator()(const char* name, double& value, const char* help) {
  add(
      name, help, FieldType::real, [&value] { return format_real(value); },
      [&value](std::string_view text) { value = parse_real(text); });
}

void FieldCollector::operator()(const char* name, std::string& value, const char* help) {
  add(
      name, help, FieldType::text, [&value] { return value; },
      [&value](std::string_view text) { value = text; });
}

void FieldCollector::operator()(const char* name, std::filesystem::path& value, const char* help) {
  add(
      name, help, FieldType::text, [&value] { return value.string(); },
      [&value](std::string_view text) { value = text; });
}

void FieldCollector::operator()(const char* name, Eigen::Vector3d& value, const char* help) {
  add(
      name, help, FieldType::reals, [&value] { return join_point(value); },
      [&value](std::string_view text) {
        const std::vector<double> values = parse_reals(text, 3);
        value = {values[0], values[1], values[2]};
      });
}

void FieldCollector::operator()(const char* name, std::vector<Eigen::Vector3d>& value,
                                const char* help) {
  add(
      name, help, FieldType::reals,
      [&value] {
        std::string text;
        for (const Eigen::Vector3d& point : value) {
          text += (text.empty() ? "" : ",") + join_point(point);
        }
        return text;
      },
      [&value](std::string_view text) { value = parse_points(text); });
}

std::string current_key(const std::string& key) {
  std::string current = key;
  for (const auto& [old_part, part] : kRenamed) {
    if (const auto start = current.find(old_part); start != std::string::npos) {
      current.replace(start, old_part.size(), part);
    }
  }
  return current;
}

Field& find_field(std::vector<Field>& fields, const std::string& key) {
  const std::string current = current_key(key);
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == current; });
  if (found != fields.end()) {
    return *found;
  }
  std::vector<std::string> keys;
  for (const Field& field : fields) {
    keys.push_back(field.key);
  }
  const std::string nearest = nearest_key(key, keys);
  fail("unknown key '", key, "'", nearest.empty() ? "" : "; the nearest known key is ", nearest);
}

void set_field(std::vector<Field>& fields, const std::string& key, std::string_view text) {
  Field& field = find_field(fields, key);
  try {
    field.set(text);
  } catch (const Error& error) {
    throw Error(concat(key, ": ", error.what()), error.kind());
  }
}

}  // namespace vo
