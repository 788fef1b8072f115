// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a JSON document, and their text.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace drillwave {

class Json;
struct JsonMember;
using JsonArray = std::vector<Json>;

/// JSON object: its members in ascending order of the bytes of their keys, each key once.
class JsonObject {
  public:
    JsonObject() = default;
    JsonObject(std::initializer_list<std::pair<std::string_view, Json>> members);

    /// Returns the value of a key. A new key is added with the value null.
    Json& operator[](std::string_view key);
    const std::vector<JsonMember>& members() const { return m_members; }

  private:
    std::vector<JsonMember> m_members;
};

/// JSON value: null, true or false, a number, a text (UTF-8), an array or an object. Infinite and NaN numbers
/// and empty optionals become null.
class Json {
  public:
    Json() = default;
    Json(std::same_as<bool> auto value) : m_value(value) {}
    Json(double value);
    template <std::integral Integer>
    requires(!std::same_as<Integer, bool>) Json(Integer value) : m_value(static_cast<std::int64_t>(value)) {}
    Json(const std::optional<double>& value);
    Json(const char* text) : m_value(std::string(text)) {}
    Json(std::string_view text) : m_value(std::string(text)) {}
    Json(const std::string& text) : m_value(text) {}
    Json(JsonArray array) : m_value(std::move(array)) {}
    Json(JsonObject object) : m_value(std::move(object)) {}

    /// Returns the JSON text: four blanks per level, one value per line, ending with a line feed. Doubles are
    /// the shortest text that reads back as the same value; whole numbers have no exponent.
    std::string text() const;

  private:
    void append(std::string& text, int level) const;

    std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, JsonArray, JsonObject> m_value;
};

/// Key and value of one member of a JSON object.
struct JsonMember {
    std::string key;
    Json value;
};

}  // namespace drillwave
