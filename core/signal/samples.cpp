// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/samples.h"

#include <algorithm>
#include <cmath>

#include "core/signal/signal_unit.h"
#include "core/signal/stated_time.h"
#include "core/signal/text_lines.h"
#include "core/text/decimal_text.h"
#include "core/text/handy_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr std::size_t linesBetweenLooks = 4096;

constexpr std::size_t fewJumps = 20;           // are jumps however many samples there are
constexpr std::size_t fewestBetweenJumps = 8;  // samples, on average

class SampleReader {
  public:
    SampleReader(const SampleSource& source, std::istream& in)
        : m_source(source), m_text(in, source.encoding) {
        m_cellCount = source.valueColumn + 1;
        for (const std::optional<std::size_t>& column : {source.timeColumn, source.secondGauge})
            if (column) m_cellCount = std::max(m_cellCount, *column + 1);
    }

    Samples read(const std::stop_token& stop, const std::function<void(std::uint64_t)>& tell) {
        if (const std::string_view what = knownFormat(m_text.beginning()); !what.empty())
            return failed(0, "this is no table: " + std::string(what));
        std::string_view line;
        while (m_samples.problem.empty() && m_text.next(line)) {
            if (m_text.number() % linesBetweenLooks == 0) {
                if (stop.stop_requested()) return failed(0, "stopped");
                if (tell) tell(m_text.bytesRead());
            }
            if (m_text.number() >= m_source.firstLine) readRow(line);
        }
        if (m_samples.problem.empty() && !m_text.problem().empty())
            return failed(m_text.number(), m_text.problem());
        if (!m_samples.problem.empty()) return failed(m_samples.problemLine, m_samples.problem);
        if (m_coarseLine > 0) return coarse(m_coarseLine);
        if (m_samples.time.size() < 2)
            return failed(0, "fewer than two samples from line " + std::to_string(m_source.firstLine) +
                                 " on: check the first line, the separator and the columns");
        if (hasCoarseTimes()) return coarse(m_firstJump);
        m_samples.hasNulTail = m_text.hasNulTail();
        return std::move(m_samples);
    }

  private:
    /// Refuses times that repeat, with the rate at which as many samples are evenly spaced.
    Samples coarse(std::size_t line) {
        Samples none = failed(
            line,
            "the time " + timeText(m_coarseLine > 0 ? m_coarseTime : m_firstJumpTime) +
                " stands in this line and in the next ones: the times are rounded too coarsely; give the "
                "sampling rate instead");
        none.firstTime = m_firstTime;
        if (m_lastTime > m_firstTime && m_sampleRows > 1) {
            none.estimatedRate =
                estimatedRate(m_firstTime, m_lastTime, m_sampleRows, m_firstStep, m_largestStep);
            none.problem += "; first time, last time and count give about " + rateText(*none.estimatedRate) +
                            " (an estimate)";
        }
        return none;
    }

    static Samples failed(std::size_t line, const std::string& problem) {
        Samples none;
        none.problemLine = line;
        none.problem = problem;
        return none;
    }

    void refuse(const std::string& reason) {
        m_samples.problem = reason;
        m_samples.problemLine = m_text.number();
    }

    void wrongRow(const std::string& reason) {
        if (m_source.wrongRows == WrongRows::refused) return refuse(reason + "; such rows can be skipped");
        if (m_samples.skipped++ == 0) m_samples.firstSkipped = m_text.number();
        m_samples.overloads += m_isOverload;
        m_hasSkipped = true;
    }

    /// The number of a column, or nothing, with the reason in m_reason.
    std::optional<double> number(const std::vector<std::string_view>& cells, std::size_t column) {
        const std::string place = "column " + std::to_string(column + 1);
        if (column >= cells.size()) {
            m_reason = place + " is missing: the row has " + std::to_string(cells.size()) + " cells";
            return std::nullopt;
        }
        std::optional<double> value = cellNumber(cells[column], m_source.format);
        if (value && std::abs(*value) < overloadValue) return value;
        const std::string cell = "`" + shortened(cells[column]) + "`";
        m_isOverload = value || isOverload(cells[column]);
        m_reason = place + (m_isOverload ? " holds " + cell + ", which stands for an overload"
                            : isMissing(cells[column])
                                ? " holds no value (" + cell + ")"
                                : ": " + cell + " is not a number" + likelyReading(cells[column]));
        return std::nullopt;
    }

    /// Says how a cell can be read that is no number with these signs.
    std::string likelyReading(std::string_view cell) const {
        RowFormat other = m_source.format;
        const bool isPoint = other.decimal == DecimalSign::point;
        other.otherSignGroups = true;
        if (cellNumber(cell, other))
            return std::string(", but one with ") + (isPoint ? "commas" : "points") +
                   " between groups of three digits, or with a decimal " + (isPoint ? "comma" : "point") +
                   ": say which";
        other.decimal = isPoint ? DecimalSign::comma : DecimalSign::point;
        if (cellNumber(cell, other))
            return std::string(", but one with a decimal ") + (isPoint ? "comma" : "point");
        return {};
    }

    /// 60 us as the double nearest to 60e-6: by division, as the inverse of the unit is a whole number.
    double inSeconds(double time) const {
        const double inverse = std::round(1 / m_source.timeUnit);
        const bool isWhole = inverse > 1 && std::abs(inverse * m_source.timeUnit - 1) < 1e-12;
        return isWhole ? time / inverse : time * m_source.timeUnit;
    }

    std::optional<double> timeIn(const std::vector<std::string_view>& cells) {
        const std::size_t column = *m_source.timeColumn;
        if (column < cells.size() && cells[column].find(':') != std::string_view::npos) {
            const std::optional<TimeStamp> stamp = timeStamp(cells[column]);
            if (stamp) {
                if (!m_firstStamp) m_firstStamp = stamp;
                return secondsSince(*m_firstStamp, *stamp);
            }
        }
        const std::optional<double> time = number(cells, column);
        return time ? std::optional(inSeconds(*time)) : std::nullopt;
    }

    void readRow(std::string_view line) {
        if (isPassedOver(line, m_source.format.separator)) return;
        const auto row = static_cast<double>(m_rows++);
        const std::vector<std::string_view>& cells =
            m_row.split(line, m_source.format.separator, m_cellCount);
        m_isOverload = false;
        std::optional<double> value = number(cells, m_source.valueColumn);
        double half = 0;
        if (value && m_source.secondGauge) {
            const std::optional<double> second = number(cells, *m_source.secondGauge);
            if (second) half = *value / 2 - *second / 2;
            value = second ? std::optional(*value / 2 + *second / 2) : std::nullopt;
        }
        std::optional<double> time = m_source.start + row * m_source.interval;
        if (value && m_source.timeColumn) time = timeIn(cells);
        if (!value || !time) return wrongRow(m_reason);
        append(*time, *value, half);
    }

    void append(double time, double value, double half) {
        if (m_sampleRows++ == 0) m_firstTime = time;
        if (m_sampleRows > 1 && !(time > m_lastTime)) {
            if (time != m_lastTime) return refuse(notLater(time));
            if (m_coarseLine > 0) return;
            // Two values at one time are a jump, as drillwave itself writes them; three are none.
            if (m_isJump) {
                m_coarseLine = m_lastLine;
                m_coarseTime = time;
                return;
            }
            m_isJump = true;
            if (m_samples.jumps++ == 0) {
                m_firstJump = m_lastLine;
                m_firstJumpTime = time;
            }
            time = std::nextafter(time, HUGE_VAL);
        } else {
            if (m_sampleRows > 1) {
                const double step = time - m_lastTime;
                if (m_firstStep == 0) m_firstStep = step;
                m_largestStep = std::max(m_largestStep, step);
                if (m_hasSkipped && step > m_samples.skippedTime) {
                    m_samples.skippedTime = step;
                    m_samples.skippedAt = m_lastTime;
                }
            }
            m_hasSkipped = false;
            m_isJump = false;
            m_lastTime = time;
            m_lastLine = m_text.number();
        }
        if (m_coarseLine > 0) return;
        if (m_samples.time.size() == mostSamples)
            return refuse("more than " + std::to_string(mostSamples) + " samples: cut the file");
        m_samples.time.push_back(time);
        m_samples.value.push_back(value);
        if (m_source.secondGauge) m_samples.halfDifference.push_back(half);
    }

    static std::string timeText(double seconds) {
        constexpr int digits = 12;  // not those that the unit of the times has added
        return inHandyUnit(seconds, Quantity::time, digits);
    }

    std::string notLater(double time) const {
        return "the time " + timeText(time) + " is not later than the one before it, " +
               timeText(m_lastTime) + ": take another column, or a sampling rate";
    }

    /// So many are no jumps but a clock that is too coarse.
    bool hasCoarseTimes() const {
        return m_samples.jumps > fewJumps && m_samples.jumps > m_samples.time.size() / fewestBetweenJumps;
    }

    const SampleSource& m_source;
    TextLines m_text;
    TableRow m_row;
    std::size_t m_cellCount = 1;
    std::size_t m_rows = 0;
    std::string m_reason;
    double m_lastTime = 0;
    std::optional<TimeStamp> m_firstStamp;
    double m_firstTime = 0, m_firstStep = 0, m_largestStep = 0;  // [s]
    std::size_t m_sampleRows = 0;                                // rows with a time and a value
    std::size_t m_lastLine = 0;                                  // of the last time that was later
    bool m_isJump = false;                                       // the last sample
    bool m_hasSkipped = false;                                   // rows since the last sample
    bool m_isOverload = false;                                   // the last cell that was no value
    std::size_t m_firstJump = 0;                                 // line
    double m_firstJumpTime = 0;
    std::size_t m_coarseLine = 0;  // where a time occurs for the first time that occurs three times
    double m_coarseTime = 0;
    Samples m_samples;
};

/// Only for what needs a number: hasRate says whether the table states it.
constexpr double placeholderInterval = 1e-6;

bool saysTime(const TableColumn& column) {
    return column.isStamp || findTimeUnit(column.unit) || isTimeName(column.name);
}

bool nameHas(const TableColumn& column, std::initializer_list<std::string_view> words) {
    const std::string name = lowerCase(column.name);
    return std::ranges::any_of(words, [&](std::string_view word) { return name.find(word) != name.npos; });
}

bool saysStrain(const TableColumn& column) {
    return nameHas(column, {"strain", "dehnung", "t\u00f6jning"});
}

bool saysSignal(const TableColumn& column) {
    return saysStrain(column) || column.name == "F" || column.name == "N" ||
           nameHas(column, {"force", "kraft", "load", "stress", "spannung", "volt", "gauge"});
}

std::optional<std::size_t> timeColumn(const std::vector<TableColumn>& columns) {
    std::optional<std::size_t> first, index;
    std::size_t count = 0;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].isStamp) return i;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i].isNumeric) continue;
        if (saysTime(columns[i])) return i;
        if (columns[i].isIndex) {
            index = i;
            continue;
        }
        if (count++ == 0 && !findSignalUnit(columns[i].unit)) first = i;
    }
    // Whole numbers that count on may be times where there is no heading; below a name they are an index, and
    // no other column is taken for times that does not say so.
    if (index && (!first || *index < *first)) {
        const bool isNameless =
            std::ranges::all_of(columns, [](const TableColumn& column) { return column.name.empty(); });
        return isNameless ? index : std::nullopt;
    }
    return count > 1 ? first : std::nullopt;
}

/// How much speaks for a column as the signal.
int rank(const TableColumn& column) {
    if (column.isIndex) return 0;
    if (findSignalUnit(column.unit)) return 4;
    if (!column.unit.empty()) return 1;  // of another quantity
    return saysSignal(column) ? 3 : 2;
}

}  // namespace

double estimatedRate(double first, double last, std::size_t samples, double firstStep, double lastStep) {
    const auto intervals = static_cast<double>(samples - 1);
    const double open = (firstStep + lastStep) / 2;
    const double low = intervals / (last - first + open), rate = intervals / (last - first);
    const double high = last - first > open ? intervals / (last - first - open) : HUGE_VAL;
    for (int digits = 1; digits < 6; ++digits) {
        const double near = parseNumber(rounded(rate, digits)).value_or(rate);
        if (near >= low && near <= high) return near;
    }
    return rate;
}

Samples readSamples(std::istream& in, const SampleSource& source, const std::stop_token& stop,
                    const std::function<void(std::uint64_t)>& tell) {
    return SampleReader(source, in).read(stop, tell);
}

SignalKind likelyKind(const TableColumn& column) {
    return saysStrain(column) ? SignalKind::strain : SignalKind::force;
}

std::optional<double> statedTimeUnit(const TableColumn& column) {
    return column.isStamp ? std::optional(1.0) : findTimeUnit(column.unit);
}

std::optional<NamedSignalUnit> statedUnit(const TableColumn& column) {
    return findSignalUnit(column.unit);
}

SampleGuess guessedSource(const DetectedTable& table) {
    SampleGuess guess;
    guess.source.format = table.format;
    guess.source.firstLine = table.firstLine;
    guess.source.interval = table.rate ? 1 / *table.rate : placeholderInterval;
    guess.hasRate = table.rate.has_value();
    guess.source.timeColumn = timeColumn(table.columns);
    if (guess.source.timeColumn) {
        const std::optional<double> unit = statedTimeUnit(table.columns[*guess.source.timeColumn]);
        guess.hasTimeUnit = unit.has_value();
        guess.source.timeUnit = unit.value_or(1);
    }
    int best = -1;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (!table.columns[i].isNumeric || guess.source.timeColumn == i) continue;
        const int now = rank(table.columns[i]);
        if (now == best) ++guess.rivals;
        if (now <= best) continue;
        best = now;
        guess.rivals = 0;
        guess.source.valueColumn = i;
    }
    if (best == 0 && guess.rivals > 0) guess.rivals = 0;
    if (guess.source.valueColumn < table.columns.size())
        guess.unit = statedUnit(table.columns[guess.source.valueColumn]);
    return guess;
}

}  // namespace drillwave
