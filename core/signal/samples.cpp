// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/samples.h"

#include <algorithm>
#include <cmath>

#include "core/signal/text_lines.h"
#include "core/text/decimal_text.h"
#include "core/text/handy_text.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr std::size_t linesBetweenLooks = 4096;

constexpr std::size_t fewJumps = 20;           // are jumps however many samples there are
constexpr std::size_t fewestBetweenJumps = 8;  // samples, on average

class SampleReader {
  public:
    SampleReader(const SampleSource& source, std::istream& in) : m_source(source), m_text(in) {
        m_cellCount = source.valueColumn + 1;
        for (const std::optional<std::size_t>& column : {source.timeColumn, source.secondGauge})
            if (column) m_cellCount = std::max(m_cellCount, *column + 1);
    }

    Samples read(const std::stop_token& stop, const std::function<void(std::uint64_t)>& tell) {
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
        if (m_samples.time.size() < 2)
            return failed(0, "fewer than two samples from line " + std::to_string(m_source.firstLine) +
                                 " on: check the first line, the separator and the columns");
        if (hasCoarseTimes())
            return failed(m_firstJump, "this time occurs twice, and so do " +
                                           std::to_string(m_samples.jumps - 1) +
                                           " others: they are too coarse, take a sampling rate instead");
        return std::move(m_samples);
    }

  private:
    static Samples failed(std::size_t line, const std::string& problem) {
        Samples none;
        none.problemLine = line;
        none.problem = problem;
        return none;
    }

    static bool isPassedOver(std::string_view line) {
        const std::string_view text = trimmed(line);
        return text.empty() || text.front() == '#';
    }

    void refuse(const std::string& reason) {
        m_samples.problem = reason;
        m_samples.problemLine = m_text.number();
    }

    void wrongRow(const std::string& reason) {
        if (m_source.wrongRows == WrongRows::refused) return refuse(reason + "; such rows can be skipped");
        if (m_samples.skipped++ == 0) m_samples.firstSkipped = m_text.number();
    }

    /// The number of a column, or nothing, with the reason in m_reason.
    std::optional<double> number(const std::vector<std::string_view>& cells, std::size_t column) {
        const std::string place = "column " + std::to_string(column + 1);
        if (column >= cells.size()) {
            m_reason = place + " is missing: the row has " + std::to_string(cells.size()) + " cells";
            return std::nullopt;
        }
        const std::optional<double> value = cellNumber(cells[column], m_source.format.decimal);
        if (!value)
            m_reason =
                place + (isMissing(cells[column]) ? " holds no value (`" + shortened(cells[column]) + "`)"
                                                  : ": `" + shortened(cells[column]) + "` is not a number");
        return value;
    }

    void readRow(std::string_view line) {
        if (isPassedOver(line)) return;
        const auto row = static_cast<double>(m_rows++);
        const std::vector<std::string_view>& cells =
            m_row.split(line, m_source.format.separator, m_cellCount);
        std::optional<double> value = number(cells, m_source.valueColumn);
        if (value && m_source.secondGauge) {
            const std::optional<double> second = number(cells, *m_source.secondGauge);
            value = second ? std::optional(*value / 2 + *second / 2) : std::nullopt;
        }
        std::optional<double> time = row * m_source.interval;
        if (value && m_source.timeColumn) {
            time = number(cells, *m_source.timeColumn);
            if (time) time = *time * m_source.timeUnit;
        }
        if (!value || !time) return wrongRow(m_reason);
        append(*time, *value);
    }

    void append(double time, double value) {
        if (!m_samples.time.empty() && !(time > m_samples.time.back())) {
            if (time != m_lastTime || m_isJump) return refuse(notLater(time));
            // Two values at one time are a jump, as drillwave itself writes them.
            m_isJump = true;
            if (m_samples.jumps++ == 0) m_firstJump = m_text.number();
            time = std::nextafter(time, HUGE_VAL);
        } else {
            m_isJump = false;
            m_lastTime = time;
        }
        if (m_samples.time.size() == mostSamples)
            return refuse("more than " + std::to_string(mostSamples) + " samples: cut the file");
        m_samples.time.push_back(time);
        m_samples.value.push_back(value);
    }

    std::string notLater(double time) const {
        constexpr int digits = 12;  // not those that the unit of the times has added
        const auto text = [](double seconds) { return inHandyUnit(seconds, Quantity::time, digits); };
        return "the time " + text(time) + " is not later than the one before it, " + text(m_lastTime) +
               ": take another column, or a sampling rate";
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
    bool m_isJump = false;  // the last sample
    std::size_t m_firstJump = 0;
    Samples m_samples;
};

}  // namespace

Samples readSamples(std::istream& in, const SampleSource& source, const std::stop_token& stop,
                    const std::function<void(std::uint64_t)>& tell) {
    return SampleReader(source, in).read(stop, tell);
}

}  // namespace drillwave
