// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/printed_text.h"

#include <array>
#include <utility>

namespace drillwave {

namespace {

using PrintedSign = std::pair<std::string_view, std::string_view>;

void replaceSign(std::string& text, const PrintedSign& sign) {
    const auto& [plain, printed] = sign;
    for (std::size_t at = text.find(plain); at != std::string::npos;
         at = text.find(plain, at + printed.size()))
        text.replace(at, plain.size(), printed);
}

/// Returns whether a character may be in a word, or in a name with underscores or dots.
bool isOfWord(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || static_cast<unsigned char>(c) >= 0x80;
}

/// Only where it is a word by itself, at whose end there may be a full stop.
void replaceSymbol(std::string& text, const PrintedSign& sign) {
    const auto& [plain, printed] = sign;
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at + 1)) {
        std::size_t end = at + plain.size();
        const bool begins = at == 0 || !isOfWord(text[at - 1]);
        if (end + 1 == text.size() && text[end] == '.') ++end;
        if (begins && (end == text.size() || !isOfWord(text[end]))) text.replace(at, plain.size(), printed);
    }
}

constexpr std::array<PrintedSign, 4> printedSigns{{{"...", "…"}, {"+-", "±"}, {">=", "≥"}, {"<=", "≤"}}};
constexpr std::array<PrintedSign, 12> printedSymbols{{{"t0", "t₀"},
                                                      {"d0", "d₀"},
                                                      {"I0", "I₀"},
                                                      {"p0", "p₀"},
                                                      {"F0", "F₀"},
                                                      {"W0", "W₀"},
                                                      {"E0", "E₀"},
                                                      {"v0", "v₀"},
                                                      {"tau", "τ"},
                                                      {"delta", "δ"},
                                                      {"gamma", "γ"},
                                                      {"beta", "β"}}};

std::string superscript(std::string_view exponent) {
    constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    if (exponent.starts_with('-')) text = "⁻";
    exponent.remove_prefix(exponent.find_first_not_of("+-0"));
    for (const char digit : exponent) text += digits[digit - '0'];
    return text;
}

}  // namespace

std::string printedUnit(std::string_view text) {
    if (text == "deg") return "°";
    std::string printed(text);
    replaceSign(printed, {"^2", "²"});
    replaceSign(printed, {"^3", "³"});
    for (const std::string_view unit : {"us", "um"}) {
        const bool ends = printed.ends_with(unit);
        if (ends && (printed.size() == unit.size() || printed[printed.size() - unit.size() - 1] == ' '))
            printed.replace(printed.size() - unit.size(), 1, "µ");
    }
    return printed;
}

std::string printedNumber(std::string_view text) {
    const std::size_t power = text.find('e');
    const bool hasPower = power != std::string_view::npos && power + 2 < text.size() &&
                          (text[power + 1] == '-' || text[power + 1] == '+');
    std::string printed(text.substr(0, hasPower ? power : text.size()));
    if (printed.starts_with('-')) printed.replace(0, 1, "−");
    return hasPower ? printed + "·10" + superscript(text.substr(power + 1)) : printed;
}

std::string printedWords(std::string_view text) {
    std::string printed(text);
    for (const PrintedSign& sign : printedSigns) replaceSign(printed, sign);
    for (const PrintedSign& sign : printedSymbols) replaceSymbol(printed, sign);
    return printed;
}

std::string PrintedStyle::number(double value, int digits) const {
    return printedNumber(m_reader.number(value, digits));
}

ReadUnit PrintedStyle::unitFor(double si, Quantity quantity) const {
    ReadUnit read = m_reader.unitFor(si, quantity);
    read.name = printedUnit(read.name);
    return read;
}

ReadUnit PrintedStyle::rateUnit(double si) const {
    return m_reader.rateUnit(si);
}

std::string PrintedStyle::patternFor(const std::string& english) const {
    return printedWords(m_reader.patternFor(english));
}

}  // namespace drillwave
