// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/text/name_text.h"
#include "core/text/text_input.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

/// Up to here doubles hold every whole number; further on, digits beyond the shortest text say nothing.
constexpr double largestWhole = 0x1p53;

void appendLine(std::string& text, int level) {
    text += '\n';
    text.append(static_cast<std::size_t>(4 * level), ' ');
}

/// Appends the escape sequence of a byte.
void appendEscaped(std::string& text, char byte) {
    constexpr std::string_view named = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt";
    constexpr std::string_view digits = "0123456789abcdef";
    text += '\\';
    if (const std::size_t at = named.find(byte); at != std::string_view::npos) {
        text += letters[at];
        return;
    }
    text += "u00";
    text += digits[static_cast<unsigned char>(byte) >> 4];
    text += digits[static_cast<unsigned char>(byte) & 0xF];
}

void appendText(std::string& text, std::string_view value) {
    text += '"';
    std::string escaped;
    for (const char byte : value)
        if (byte == '"' || byte == '\\' || static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F)
            appendEscaped(escaped, byte);
        else
            escaped += byte;
    // Beyond ASCII printable() writes as JSON does.
    text += isUtf8(escaped) ? printable(escaped) : escaped;
    text += '"';
}

/// The shortest text that reads back as the same double.
void appendJsonNumber(std::string& text, double value) {
    std::string number = formatNumber(value);
    if (std::abs(value) > largestWhole && number.find('e') == std::string::npos) {
        std::array<char, 32> buffer{};
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific);
        std::string digits(buffer.data(), std::ranges::find(buffer, 'e'));
        std::erase(digits, '.');
        digits.resize(number.size(), '0');
        number = std::move(digits);
    }
    text += number;
}

}  // namespace

JsonObject::JsonObject(std::initializer_list<std::pair<std::string_view, Json>> members) {
    for (const auto& [key, value] : members) (*this)[key] = value;
}

Json& JsonObject::operator[](std::string_view key) {
    auto place = std::ranges::lower_bound(m_members, key, {}, &JsonMember::key);
    if (place == m_members.end() || place->key != key)
        place = m_members.insert(place, JsonMember{std::string(key), Json()});
    return place->value;
}

Json::Json(double value) {
    if (!std::isfinite(value)) return;
    if (std::abs(value) <= largestWhole && value == std::trunc(value))
        m_value = static_cast<std::int64_t>(value);
    else
        m_value = value;
}

Json::Json(const std::optional<double>& value) {
    if (value) *this = Json(*value);
}

std::string Json::text() const {
    std::string text;
    append(text, 0);
    return text + "\n";
}

void Json::append(std::string& text, int level) const {
    const auto close = [&](char bracket) {
        appendLine(text, level);
        text += bracket;
    };
    if (std::holds_alternative<std::nullptr_t>(m_value)) text += "null";
    if (const auto* truth = std::get_if<bool>(&m_value)) text += *truth ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&m_value)) text += std::to_string(*whole);
    if (const auto* number = std::get_if<double>(&m_value)) appendJsonNumber(text, *number);
    if (const auto* string = std::get_if<std::string>(&m_value)) appendText(text, *string);
    if (const auto* array = std::get_if<JsonArray>(&m_value)) {
        text += '[';
        for (const Json& value : *array) {
            if (&value != array->data()) text += ',';
            appendLine(text, level + 1);
            value.append(text, level + 1);
        }
        close(']');
    }
    if (const auto* object = std::get_if<JsonObject>(&m_value)) {
        text += '{';
        for (const JsonMember& member : object->members()) {
            if (&member != object->members().data()) text += ',';
            appendLine(text, level + 1);
            appendText(text, member.key);
            text += ": ";
            member.value.append(text, level + 1);
        }
        close('}');
    }
}

}  // namespace drillwave
