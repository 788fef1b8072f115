// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a JSON document, and the text of it.
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

/// Members in the order of their keys (bytes), each key once.
class JsonObject {
  public:
    JsonObject() = default;
    JsonObject(std::initializer_list<std::pair<std::string_view, Json>> members);

    /// The value of a key, null where it is new.
    Json& operator[](std::string_view key);
    const std::vector<JsonMember>& members() const { return m_members; }

  private:
    std::vector<JsonMember> m_members;
};

/// A value: null, true or false, a number, a text (UTF-8), an array, an object. Numbers that are not finite
/// and options without a value are null.
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

    /// The document: four blanks a level, a line for each value, keys in order, numbers as the shortest text
    /// that reads back as the same double, whole numbers without an exponent; ends with a line feed.
    std::string text() const;

  private:
    void append(std::string& text, int level) const;

    std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, JsonArray, JsonObject> m_value;
};

/// Member of an object.
struct JsonMember {
    std::string key;
    Json value;
};

}  // namespace drillwave
