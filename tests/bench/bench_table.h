// SPDX-License-Identifier: GPL-3.0-or-later
// Table of a benchmark, printed row by row as it is measured: for people, as CSV or as JSON.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "core/text/units.h"

namespace drillwave::bench {

enum class Format { text, csv, json };

struct Column {
    enum class Kind {
        word,
        number,  ///< in all digits
        time,    ///< s; for people μs
        ratio,   ///< for people of three digits
        share,   ///< for people per cent
    };
    const char* key;
    int width;
    Kind kind = Kind::number;
};

/// A cell; NaN where there is no value.
using Cell = std::variant<std::string, double>;

class Table {
  public:
    Table(Format format, std::vector<Column> columns) : m_format(format), m_columns(std::move(columns)) {
        if (m_format == Format::json) return;
        for (const Column& column : m_columns)
            print(column, m_format == Format::text && column.kind == Column::Kind::time
                              ? microseconds(column.key)
                              : column.key);
        endLine();
    }
    ~Table() {
        if (m_format == Format::json) std::printf("%s]\n", m_rows == 0 ? "[" : "\n");
    }
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;

    void add(const std::vector<Cell>& cells) {
        if (m_format == Format::json) std::printf("%s\n {", m_rows == 0 ? "[" : ",");
        ++m_rows;
        for (std::size_t i = 0; i < m_columns.size(); ++i)
            print(m_columns[i], words(m_columns[i], cells.at(i)));
        endLine();
        std::fflush(stdout);
    }

  private:
    /// "median_s" → "median_us"
    static std::string microseconds(std::string key) { return key.insert(key.size() - 1, "u"); }

    std::string words(const Column& column, const Cell& cell) const {
        if (const auto* word = std::get_if<std::string>(&cell))
            return m_format == Format::json ? '"' + *word + '"' : *word;
        const double value = std::get<double>(cell);
        if (std::isnan(value)) return m_format == Format::text ? "-" : m_format == Format::json ? "null" : "";
        if (m_format != Format::text || column.kind == Column::Kind::number) return formatNumber(value);
        char text[64];
        switch (column.kind) {
            case Column::Kind::time:
                std::snprintf(text, sizeof text, value < 1e-3 ? "%.3f" : "%.0f", 1e6 * value);
                break;
            case Column::Kind::share:
                std::snprintf(text, sizeof text, "%.0f%%", 100 * value);
                break;
            default:
                std::snprintf(text, sizeof text, "%.3g", value);
        }
        return text;
    }

    void print(const Column& column, const std::string& text) {
        const bool first = &column == m_columns.data();
        if (m_format == Format::json)
            std::printf("%s\"%s\": %s", first ? "" : ", ", column.key, text.c_str());
        else if (m_format == Format::csv)
            std::printf("%s%s", first ? "" : ",", text.c_str());
        else if (column.kind == Column::Kind::word)
            std::printf("%s%-*s", first ? "" : " ", column.width, text.c_str());
        else
            std::printf("%s%*s", first ? "" : " ", column.width, text.c_str());
    }
    void endLine() const { std::printf(m_format == Format::json ? "}" : "\n"); }

    Format m_format;
    std::vector<Column> m_columns;
    long m_rows = 0;
};

}  // namespace drillwave::bench
