// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/signal_reading.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/numeric/compensated_sum.h"
#include "core/text/decimal_text.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr std::size_t headLines = 2000;
constexpr double restShare =
    0.03;  // of a record, from its beginning, in which nothing has happened, probably

void rewind(std::istream& in) {
    in.clear();
    in.seekg(0);
}

/// Below the size of the largest table of a blow; all samples are kept.
constexpr std::size_t allPoints = mostSamples;

class SignalReader {
  public:
    SignalReader(std::istream& in, const SignalOptions& options, const SignalBar& bar,
                 const std::stop_token& stop)
        : m_in(in), m_options(options), m_bar(bar), m_stop(stop) {}

    SignalReading read() {
        if (detect() && chooseColumns() && chooseTime() && readAll()) {
            chooseUnit();
            judge();
            shape();
        }
        return std::move(m_reading);
    }

  private:
    bool fail(Message problem, bool isWrongOption = false) {
        m_reading.problem = std::move(problem);
        m_reading.isWrongOption = isWrongOption;
        return false;
    }

    void ask(const char* question) {
        if (std::ranges::find(m_reading.questions, question) == m_reading.questions.end())
            m_reading.questions.emplace_back(question);
    }

    std::istream& stream() { return m_turned ? *m_turned : m_in; }

    bool detect() {
        TextLines text(m_in, m_options.encoding);
        if (const std::string_view what = knownFormat(text.beginning()); !what.empty())
            return fail({translatable("this is not a table: it is %1"), {Message::ofTable(what)}});
        rewind(m_in);
        std::vector<std::string> lines = firstLines(m_in, headLines, m_options.encoding);
        rewind(m_in);
        m_reading.table = tableOf(lines);
        if (m_reading.table.hasRows && !m_options.firstLine) {
            m_turned = std::make_unique<std::istringstream>(
                turnedTable(m_in, m_reading.table.format, m_options.encoding));
            lines = firstLines(*m_turned, headLines);
            rewind(*m_turned);
            SignalOptions plain;
            m_reading.table = detectTable(lines, RowFormat{',', DecimalSign::point});
            m_reading.table.hasRows = true;
            remark("rows",
                   translatable("each channel is a row: the table was transposed, lines count its columns"));
        }
        m_reading.encoding = m_options.encoding;
        if (lines.empty()) return fail(unreadable());
        if (!m_reading.table.hasSamples())
            return fail(
                {translatable("no line of numbers is found in the first %1 lines; is it a table of samples? "
                              "Give --separator, --decimal or --first-line"),
                 {std::to_string(lines.size())}});
        m_reading.encoding = encodingOf();
        return true;
    }

    /// As far as the head of the text shows it.
    TextEncoding encodingOf() {
        TextLines text(m_in, m_options.encoding);
        std::string_view line;
        for (std::size_t i = 0; i < headLines && text.next(line); ++i) {
        }
        const TextEncoding found = text.encoding();
        rewind(m_in);
        return found;
    }

    Message unreadable() {
        TextLines text(m_in, m_options.encoding);
        std::string_view line;
        text.next(line);
        rewind(m_in);
        if (!text.problem().empty())
            return {translatable("line %1: %2"), {std::to_string(text.number()), text.problem()}};
        return translatable("the file is empty");
    }

    DetectedTable tableOf(const std::vector<std::string>& lines) const {
        DetectedTable table = detectTable(lines);
        if (m_options.separator || m_options.decimal) {
            RowFormat format = table.format;
            if (m_options.separator) format.separator = *m_options.separator;
            if (m_options.decimal) format.decimal = *m_options.decimal;
            const DecimalSign other =
                format.decimal == DecimalSign::point ? DecimalSign::comma : DecimalSign::point;
            table = detectTable(lines, format);
            const auto numeric = [](const DetectedTable& t) {
                return std::ranges::count_if(t.columns, &TableColumn::isNumeric);
            };
            if (!m_options.decimal) {
                const DetectedTable second = detectTable(lines, RowFormat{format.separator, other});
                if (numeric(second) > numeric(table)) table = second;
            }
            if (m_options.decimal) {
                table.isDecimalOpen = false;
                table.format.otherSignGroups = true;
            }
        }
        if (m_options.firstLine) {
            const RowFormat format = table.format;
            table = tableFrom(lines, format, *m_options.firstLine);
            table.format.otherSignGroups |= format.otherSignGroups;
        }
        return table;
    }

    std::optional<std::size_t> columnNamed(const std::string& wanted, Message& problem) const {
        const std::vector<TableColumn>& columns = m_reading.table.columns;
        if (const auto found = drillwave::columnNamed(columns, wanted)) return found;
        std::string list;
        for (std::size_t i = 0; i < std::min<std::size_t>(columns.size(), 12); ++i)
            list += (i ? ", " : "") + std::to_string(i + 1) +
                    (columns[i].name.empty() ? std::string() : " `" + shortened(columns[i].name) + "`");
        problem = {translatable("there is no column `%1`; there are: %2"), {shortened(wanted), list}};
        return std::nullopt;
    }

    bool chooseColumns() {
        m_guess = guessedSource(m_reading.table);
        m_reading.source = m_guess.source;
        SampleSource& source = m_reading.source;
        source.encoding = m_turned ? TextEncoding::found : m_options.encoding;
        source.wrongRows = m_options.wrongRows;
        Message problem;
        if (!m_options.timeColumn.empty()) {
            source.timeColumn = columnNamed(m_options.timeColumn, problem);
            if (!source.timeColumn) return fail(std::move(problem), true);
        }
        if (!m_options.signalColumn.empty()) {
            const std::string& wanted = m_options.signalColumn;
            std::optional<std::size_t> first = columnNamed(wanted, problem);
            const std::size_t plus = wanted.find('+');
            if (!first && plus != std::string::npos) {
                first = columnNamed(std::string(trimmed(wanted.substr(0, plus))), problem);
                const auto second = columnNamed(std::string(trimmed(wanted.substr(plus + 1))), problem);
                if (!second) return fail(std::move(problem), true);
                source.secondGauge = second;
            }
            if (!first) return fail(std::move(problem), true);
            source.valueColumn = *first;
            if (source.timeColumn == source.valueColumn && m_options.timeColumn.empty())
                source.timeColumn = {};
        } else {
            // Another column than the one of times.
            if (source.timeColumn == source.valueColumn)
                for (std::size_t i = 0; i < m_reading.table.columns.size(); ++i)
                    if (m_reading.table.columns[i].isNumeric && i != *source.timeColumn) {
                        source.valueColumn = i;
                        break;
                    }
            if (m_guess.rivals > 0) ask("column");
        }
        if (source.timeColumn == source.valueColumn)
            return fail(
                {translatable("column %1 cannot be time and signal; choose another by --signal-column"),
                 {std::to_string(source.valueColumn + 1)}},
                true);
        if (m_reading.table.isDecimalOpen) ask("decimal");
        return true;
    }

    bool chooseTime() {
        SampleSource& source = m_reading.source;
        if (m_options.rate) {
            source.timeColumn = {};
            source.interval = 1 / *m_options.rate;
            m_reading.rate = m_options.rate;
            m_reading.timeFrom = FactSource::option;
            return true;
        }
        if (source.timeColumn) {
            const TableColumn& column = m_reading.table.columns[*source.timeColumn];
            const std::optional<double> stated = statedTimeUnit(column);
            if (m_options.timeUnit) {
                source.timeUnit = *m_options.timeUnit;
                m_reading.timeFrom = FactSource::option;
            } else if (stated) {
                source.timeUnit = *stated;
            } else {
                source.timeUnit = 1;
                m_reading.timeFrom = FactSource::assumed;
                ask("time_unit");
            }
            return true;
        }
        const DetectedTable& table = m_reading.table;
        m_reading.rate = table.rate ? table.rate : table.bareRate;
        if (!table.rate) {
            m_reading.timeFrom = FactSource::assumed;
            ask("rate");
        }
        source.interval = m_reading.rate ? 1 / *m_reading.rate : 1;
        return true;
    }

    bool readAll() {
        SampleSource& source = m_reading.source;
        m_reading.samples = readSamples(stream(), source, m_stop);
        rewind(stream());
        if (m_reading.samples.estimatedRate) {
            // The times are too coarse: even ones from the first to the last, to be confirmed.
            const Samples coarse = std::move(m_reading.samples);
            remark("times_repeat",
                   {translatable("line %1: %2"), {std::to_string(coarse.problemLine), coarse.problem}});
            source.timeColumn = {};
            source.start = coarse.firstTime;
            source.interval = 1 / *coarse.estimatedRate;
            m_reading.rate = coarse.estimatedRate;
            m_reading.timeFrom = FactSource::estimated;
            ask("rate");
            m_reading.samples = readSamples(stream(), source, m_stop);
            rewind(stream());
        }
        const Samples& samples = m_reading.samples;
        if (samples.problem.empty()) {
            remarkOnRows();
            return true;
        }
        const bool hint = source.wrongRows == WrongRows::refused &&
                          samples.problem.find("rows can be skipped") != std::string::npos;
        Message text(samples.problem);
        if (samples.problemLine > 0)
            text = {translatable("line %1: %2"), {std::to_string(samples.problemLine), text}};
        if (hint) text = {translatable("%1 (--rows skip)"), {text}};
        return fail(std::move(text));
    }

    void remark(const char* code, Message text) { m_reading.remarks.push_back({code, std::move(text)}); }

    void remarkOnRows() {
        const Samples& samples = m_reading.samples;
        if (samples.hasNulTail)
            remark("nul_tail", translatable("NUL bytes end the table: the recorder did not fill its file"));
        if (samples.skipped == 0) return;
        remark("skipped_rows", {translatable("%1 rows without a number are skipped, the first is line %2"),
                                {std::to_string(samples.skipped), std::to_string(samples.firstSkipped)}});
        if (samples.overloads > 0)
            remark("overload", {translatable("%1 of them are marked as overload of the recorder"),
                                {std::to_string(samples.overloads)}});
    }

    void chooseUnit() {
        const TableColumn& column = m_reading.table.columns[m_reading.source.valueColumn];
        m_reading.unit = statedUnit(column);
        if (m_options.unit) {
            m_reading.unit = m_options.unit;
            m_reading.unitFrom = FactSource::option;
        } else if (!m_reading.unit) {
            m_reading.unitFrom = FactSource::assumed;
        }
        m_reading.forcePerNumber = force();
    }

    /// N that a number of the table stands for; 0 where something is open, which is asked for.
    double force() {
        const std::optional<NamedSignalUnit>& unit = m_reading.unit;
        if (!unit) {
            ask("unit");
            return 0;
        }
        const std::optional<SignalScale>& scale = m_options.scale;
        const bool isVoltageAlone = unit->kind == SignalKind::voltage && !m_options.excitation;
        const bool isOfForce =
            isVoltageAlone || unit->kind == SignalKind::force || unit->kind == SignalKind::velocity;
        // Newtons for a volt or a m/s, or so many times a force; a factor of a strain leaves it a strain.
        if (scale && (scale->isPerUnit || isOfForce)) return scale->factor * unit->unit.factor;
        GaugedBar bar;
        const std::optional<double> area = m_options.area ? m_options.area : m_bar.area;
        const std::optional<double> modulus = m_options.modulus ? m_options.modulus : m_bar.modulus;
        bar.area = area.value_or(0);
        bar.axialStiffness = bar.area * modulus.value_or(0);
        bar.gaugeFactor = m_options.gaugeFactor.value_or(bar.gaugeFactor);
        bar.activeGauges = m_options.bridge.value_or(bar.activeGauges);
        bar.gain = m_options.gain.value_or(bar.gain);
        bar.excitation = m_options.excitation.value_or(bar.excitation);
        bar.impedance = m_bar.impedance.value_or(0);
        const SignalKind kind = unit->kind;
        // Volts are no newtons: what the bridge and the amplifier made of them is to be said.
        if (kind == SignalKind::voltage &&
            !(m_options.excitation && m_options.bridge && m_options.gaugeFactor)) {
            ask("unit");
            if (m_options.excitation && !m_options.bridge) ask("bridge");
            if (m_options.excitation && !m_options.gaugeFactor) ask("gauge_factor");
        }
        if (kind == SignalKind::bridge && !m_options.bridge) ask("bridge");
        if (kind == SignalKind::bridge && !m_options.gaugeFactor) ask("gauge_factor");
        const bool needsBar =
            kind == SignalKind::strain || kind == SignalKind::bridge || kind == SignalKind::voltage;
        if ((needsBar || kind == SignalKind::stress) && !area && !isVoltageAlone) ask("area");
        if (needsBar && !modulus && !isVoltageAlone) ask("modulus");
        if (kind == SignalKind::velocity && !m_bar.impedance) ask("impedance");
        const bool isOpen = std::ranges::any_of(m_reading.questions, [](const std::string& question) {
            return question == "unit" || question == "area" || question == "modulus" ||
                   question == "bridge" || question == "gauge_factor" || question == "impedance";
        });
        return isOpen ? 0 : (scale ? scale->factor : 1) * forcePerNumber(kind, unit->unit.factor, bar);
    }

    /// The zero line, the sign, the range, and what is remarkable.
    void judge() {
        const Samples& samples = m_reading.samples;
        m_reading.quality = signalQuality(samples);
        SignalRecipe& recipe = m_recipe;
        const bool isForce = !m_reading.unit || m_reading.unit->kind == SignalKind::force;
        if (m_options.zero) {
            recipe.zeroLine = ZeroLine::chosen;
            recipe.zeroValue = meanBetween(m_options.zero->first, m_options.zero->second);
        } else if (!isForce) {
            recipe.zeroLine = ZeroLine::ofFirstSamples;
            recipe.zeroSpan = restShare * (samples.time.back() - samples.time.front());
        }
        m_reading.zero = zeroOf(samples, recipe);
        m_sign = signOfPeak(samples, recipe) * (m_options.invert ? -1 : 1);
        const double zero = m_reading.zero;
        const bool hasBothSigns =
            std::ranges::any_of(samples.value, [&](double value) { return m_sign * (value - zero) < 0; });
        m_reading.range = {samples.time.front(), samples.time.back()};
        if (m_options.from || m_options.to) {
            m_reading.range.from = m_options.from.value_or(m_reading.range.from);
            m_reading.range.to = m_options.to.value_or(m_reading.range.to);
        } else if (!isForce || hasBothSigns) {
            if (const auto span = spanAroundPeak(samples, recipe)) m_reading.range = *span;
        }
        for (SignalRemark& remark : qualityRemarks(m_reading.quality, samples))
            if (m_reading.isTimeKnown() || remark.code != "several_blows")
                m_reading.remarks.push_back(std::move(remark));
        const double skippedEnd = samples.skippedAt + samples.skippedTime;
        if (samples.skipped > 0 && samples.skippedAt < m_reading.range.to &&
            skippedEnd > m_reading.range.from && samples.skippedTime > 0)
            remark(
                "gap_at_peak",
                {translatable(
                     "skipped rows leave a gap of %1 in the blow, from %2: it is filled by a straight line"),
                 {inHandyUnit(samples.skippedTime, Quantity::time, 4),
                  inHandyUnit(samples.skippedAt, Quantity::time, 6)}});
    }

    double meanBetween(double from, double to) {
        CompensatedSum<double> sum;
        std::size_t count = 0;
        const Samples& samples = m_reading.samples;
        for (std::size_t i = 0; i < samples.time.size(); ++i)
            if (samples.time[i] >= from && samples.time[i] <= to) {
                sum += samples.value[i];
                ++count;
            }
        if (count == 0)
            fail({translatable("no sample lies between the times of --zero, %1 and %2"),
                  {inHandyUnit(from, Quantity::time), inHandyUnit(to, Quantity::time)}},
                 true);
        return count == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(count);
    }

    void shape() {
        if (!m_reading.problem.isEmpty()) return;
        m_reading.forcePerNumber *= m_sign;
        if (m_reading.isOpen()) return;
        m_recipe.use = SignalUse::blow;
        m_recipe.negatives = Negatives::clipped;
        m_recipe.forcePerNumber = m_reading.forcePerNumber;
        m_recipe.from = m_reading.range.from;
        m_recipe.to = m_reading.range.to;
        m_recipe.points = allPoints;
        m_reading.recipe = m_recipe;
        m_reading.blow = shapedSignal(m_reading.samples, m_recipe, m_stop);
        if (!m_reading.blow.problem.empty()) fail(Message(m_reading.blow.problem));
    }

    std::istream& m_in;
    const SignalOptions& m_options;
    const SignalBar& m_bar;
    std::stop_token m_stop;
    std::unique_ptr<std::istringstream> m_turned;
    SampleGuess m_guess;
    SignalRecipe m_recipe;
    double m_sign = 1;
    SignalReading m_reading;
};

}  // namespace

std::string_view name(FactSource source) {
    static constexpr EnumNames<FactSource> names{{{FactSource::header, "header"},
                                                  {FactSource::option, "option"},
                                                  {FactSource::estimated, "estimated"},
                                                  {FactSource::assumed, "assumed"}}};
    return names[source];
}

bool SignalReading::isTimeKnown() const {
    return timeFrom == FactSource::header || timeFrom == FactSource::option;
}

std::string_view SignalReading::peakUnit() const {
    if (hasForce()) return "kN";
    return unit ? unit->unit.name : std::string_view();
}

double SignalReading::peak() const {
    if (samples.value.empty()) return 0;
    const auto largest =
        std::ranges::max_element(samples.value, {}, [&](double value) { return std::abs(value - zero); });
    const double height = *largest - zero;
    return hasForce() ? height * forcePerNumber / 1e3 : height;
}

SignalReading readSignal(std::istream& in, const SignalOptions& options, const SignalBar& bar,
                         const std::stop_token& stop) {
    return SignalReader(in, options, bar, stop).read();
}

std::string turnedTable(std::istream& in, const RowFormat& format, TextEncoding encoding) {
    TextLines text(in, encoding);
    TableRow row;
    std::vector<std::vector<std::string>> channels;
    std::string_view line;
    constexpr std::size_t mostNames = 3;
    std::size_t longest = 0;
    while (text.next(line)) {
        if (isPassedOver(line, format.separator)) continue;
        const std::vector<std::string_view>& cells = row.split(line, format.separator, mostSamples);
        // Name, and unit or source beside it, up to the first number.
        std::size_t begin = 0;
        std::string name;
        while (begin < std::min(mostNames, cells.size()) && !cellNumber(cells[begin], format)) {
            const std::string cell(cells[begin]);
            name += begin == 0 ? cell : isKnownUnit(cell) ? " [" + cell + "]" : " " + cell;
            ++begin;
        }
        std::vector<std::string>& channel = channels.emplace_back();
        channel.push_back("\"" + name + "\"");
        for (std::size_t i = begin; i < cells.size(); ++i) {
            const std::optional<double> value = cellNumber(cells[i], format);
            channel.push_back(value ? formatNumber(*value) : "\"" + std::string(cells[i]) + "\"");
        }
        while (channel.size() > 1 && channel.back() == "\"\"") channel.pop_back();
        longest = std::max(longest, channel.size());
    }
    std::string turned;
    for (std::size_t i = 0; i < longest; ++i)
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (i < channels[c].size()) turned += channels[c][i];
            turned += c + 1 < channels.size() ? ',' : '\n';
        }
    return turned;
}

std::optional<SignalScale> parseScale(std::string_view text) {
    const std::string plain = withPlainSigns(text);
    const std::string_view scale = trimmed(plain);
    const std::size_t length = numberLength(scale);
    if (length == 0) return std::nullopt;
    const std::optional<double> factor = parseNumber(scale.substr(0, length));
    if (!factor || *factor == 0) return std::nullopt;
    const std::string_view unit = trimmed(scale.substr(length));
    if (unit.empty()) return SignalScale{*factor, false};
    // Impedance, for velocities.
    if (const Unit* impedance = findUnit(Quantity::damping, unit))
        return SignalScale{impedance->toSi(*factor), true};
    const std::size_t slash = unit.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto above = findSignalUnit(unit.substr(0, slash));
    const auto below = findSignalUnit(unit.substr(slash + 1));
    if (!above || !below || above->kind != SignalKind::force) return std::nullopt;
    return SignalScale{*factor * above->unit.factor / below->unit.factor, true};
}

}  // namespace drillwave
