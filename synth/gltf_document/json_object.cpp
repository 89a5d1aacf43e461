#include "synth/gltf_document/json_object.h"

#include <utility>

#include "vo/core/error.h"

namespace synth {
namespace {

using nlohmann::json;

std::string shown(const json& value) {
  constexpr std::size_t kLongest = 40;
  if (value.is_structured()) {
    return value.is_array() ? "an array" : "an object";
  }
  std::string text = value.dump();
  if (text.size() > kLongest) {
    text.replace(kLongest, std::string::npos, "...");
  }
  return text;
}

std::string numbered(const std::string& key, std::size_t index) {
  return key + '[' + std::to_string(index) + ']';
}

}  // namespace

JsonObject::JsonObject(const json& document, std::string file)
    : JsonObject(document, std::move(file), {}) {}

JsonObject::JsonObject(const json& value, std::string file, std::string element)
    : value_(&value), file_(std::move(file)), element_(std::move(element)) {
  vo::require(value.is_object(), place(), ": is ", shown(value), ", expected an object");
}

std::vector<std::string> JsonObject::keys() const {
  std::vector<std::string> keys;
  for (const auto& item : value_->items()) {
    keys.push_back(item.key());
  }
  return keys;
}

std::optional<std::size_t> JsonObject::whole_number(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_number_unsigned()) {
    reject(key, *value, "a whole number");
  }
  return value->get<std::size_t>();
}

std::size_t JsonObject::required_whole_number(const std::string& key) const {
  const std::optional<std::size_t> number = whole_number(key);
  vo::require(number.has_value(), place(), ": has no ", key, ", expected a whole number");
  return *number;
}

std::optional<double> JsonObject::number(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_number()) {
    reject(key, *value, "a number");
  }
  return value->get<double>();
}

std::optional<bool> JsonObject::flag(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_boolean()) {
    reject(key, *value, "true or false");
  }
  return value->get<bool>();
}

std::optional<std::string> JsonObject::text(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_string()) {
    reject(key, *value, "a string");
  }
  return value->get<std::string>();
}

std::string JsonObject::required_text(const std::string& key) const {
  std::optional<std::string> found = text(key);
  vo::require(found.has_value(), place(), ": has no ", key, ", expected a string");
  return *std::move(found);
}

std::vector<double> JsonObject::numbers(const std::string& key, std::size_t size) const {
  std::vector<double> numbers = all_numbers(key);
  vo::require(!has(key) || numbers.size() == size, place(), ": ", key, " has ", numbers.size(),
              " elements, expected ", size);
  return numbers;
}

std::vector<double> JsonObject::all_numbers(const std::string& key) const {
  std::vector<double> numbers;
  const json* values = find_array(key);
  if (values == nullptr) {
    return numbers;
  }
  for (std::size_t i = 0; i < values->size(); ++i) {
    numbers.push_back(checked_number((*values)[i], numbered(key, i)));
  }
  return numbers;
}

std::vector<std::vector<double>> JsonObject::number_rows(const std::string& key,
                                                         std::size_t columns) const {
  return rows<double>(key, columns, [this](const json& value, const std::string& name) {
    return checked_number(value, name);
  });
}

std::vector<std::string> JsonObject::texts(const std::string& key) const {
  std::vector<std::string> texts;
  const json* values = find_array(key);
  if (values == nullptr) {
    return texts;
  }
  for (std::size_t i = 0; i < values->size(); ++i) {
    if (!(*values)[i].is_string()) {
      reject(numbered(key, i), (*values)[i], "a string");
    }
    texts.push_back((*values)[i].get<std::string>());
  }
  return texts;
}

std::optional<std::size_t> JsonObject::index(const std::string& key, std::size_t size) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  return checked_index(*value, key, size);
}

std::size_t JsonObject::required_index(const std::string& key, std::size_t size) const {
  const std::optional<std::size_t> found = index(key, size);
  vo::require(found.has_value(), place(), ": has no ", key, ", expected an index");
  return *found;
}

std::vector<std::size_t> JsonObject::indices(const std::string& key, std::size_t size) const {
  std::vector<std::size_t> indices;
  const json* values = find_array(key);
  if (values == nullptr) {
    return indices;
  }
  for (std::size_t i = 0; i < values->size(); ++i) {
    indices.push_back(checked_index((*values)[i], numbered(key, i), size));
  }
  return indices;
}

std::vector<std::vector<std::size_t>> JsonObject::index_rows(const std::string& key,
                                                             std::size_t columns,
                                                             std::size_t size) const {
  return rows<std::size_t>(key, columns, [this, size](const json& value, const std::string& name) {
    return checked_index(value, name, size);
  });
}

std::optional<JsonObject> JsonObject::object(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  return JsonObject(*value, file_, child(key));
}

JsonObject JsonObject::required_object(const std::string& key) const {
  std::optional<JsonObject> found = object(key);
  vo::require(found.has_value(), place(), ": has no ", key, ", expected an object");
  return *std::move(found);
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) const {
  std::vector<JsonObject> objects;
  const json* values = find_array(key);
  if (values == nullptr) {
    return objects;
  }
  objects.reserve(values->size());
  for (std::size_t i = 0; i < values->size(); ++i) {
    objects.push_back(JsonObject((*values)[i], file_, child(numbered(key, i))));
  }
  return objects;
}

std::optional<JsonObject> JsonObject::extension(const std::string& name) const {
  const std::optional<JsonObject> extensions = object("extensions");
  return extensions ? extensions->object(name) : std::nullopt;
}

const json* JsonObject::find(const std::string& key) const {
  const auto found = value_->find(key);
  return found == value_->end() ? nullptr : &*found;
}

const json* JsonObject::find_array(const std::string& key) const {
  const json* value = find(key);
  if (value != nullptr && !value->is_array()) {
    reject(key, *value, "an array");
  }
  return value;
}

double JsonObject::checked_number(const json& value, const std::string& key) const {
  if (!value.is_number()) {
    reject(key, value, "a number");
  }
  return value.get<double>();
}

/// Reads an array of arrays of `columns` elements; `read` gets each element and its name.
template <typename Element, typename Read>
std::vector<std::vector<Element>> JsonObject::rows(const std::string& key, std::size_t columns,
                                                   const Read& read) const {
  std::vector<std::vector<Element>> rows;
  const json* values = find_array(key);
  for (std::size_t i = 0; values != nullptr && i < values->size(); ++i) {
    const json& row = (*values)[i];
    const std::string name = numbered(key, i);
    if (!row.is_array() || row.size() != columns) {
      reject(name, row, "an array of " + std::to_string(columns) + " elements");
    }
    rows.emplace_back();
    for (std::size_t k = 0; k < columns; ++k) {
      rows.back().push_back(read(row[k], numbered(name, k)));
    }
  }
  return rows;
}

std::size_t JsonObject::checked_index(const json& value, const std::string& key,
                                      std::size_t size) const {
  if (!value.is_number_unsigned() || value.get<std::size_t>() >= size) {
    reject(key, value,
           size == 0 ? "none, as there is nothing to refer to"
                     : "an index below " + std::to_string(size));
  }
  return value.get<std::size_t>();
}

std::string JsonObject::child(const std::string& key) const {
  return element_.empty() ? key : element_ + '.' + key;
}

void JsonObject::reject(const std::string& key, const json& value,
                        const std::string& expected) const {
  vo::fail(place(), ": ", key, " is ", shown(value), ", expected ", expected);
}

}  // namespace synth
