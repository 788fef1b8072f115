// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters and outputs on the written pages against the tables that the program works with.
#include <QRegularExpression>
#include <QTest>
#include <map>
#include <set>

#include "core/blow/outputs.h"
#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/manual/reference.h"
#include "core/model/parameter.h"
#include "core/model/section_field.h"

using namespace drillwave;

namespace {

using Row = std::vector<std::string>;

const std::vector<Chapter>& englishManual() {
    static const std::vector<Chapter> manual = manualChapters(plainStyle());
    return manual;
}

/// Cells under their headings, of every row of a page whose table has them all.
std::vector<std::map<std::string, std::string>> rowsOf(const char* chapter,
                                                       std::initializer_list<const char*> headings) {
    std::vector<std::map<std::string, std::string>> found;
    for (const ManualBlock& block : readMarkdown(findChapter(englishManual(), chapter)->text)) {
        if (block.kind != ManualBlock::Kind::table) continue;
        const Row& header = block.rows.front();
        const bool hasAll = std::ranges::all_of(headings, [&header](const char* heading) {
            return std::ranges::find(header, heading) != header.end();
        });
        if (!hasAll) continue;
        for (std::size_t i = 1; i < block.rows.size(); ++i) {
            std::map<std::string, std::string>& row = found.emplace_back();
            row["first"] = block.rows[i].front();
            for (std::size_t column = 0; column < header.size(); ++column)
                row[header[column]] = block.rows[i][column];
        }
    }
    return found;
}

/// As the program reads numbers and units: "20 000 mm²" is "20000 mm^2", "10⁶" is "1e6".
QString asTyped(const std::string& cell) {
    QString text = QString::fromStdString(cell).section(u';', 0, 0);
    static const QRegularExpression groups(QStringLiteral("(\\d) (?=\\d{3}\\b)")), commas(", [a-z].*$");
    text.replace(groups, QStringLiteral("\\1")).remove(commas);
    for (const auto& [from, to] :
         {std::pair("−", "-"), std::pair("10¹⁸", "1e18"), std::pair("10⁹", "1e9"), std::pair("10⁶", "1e6"),
          std::pair("2³¹ - 1", "2147483647"), std::pair("µ", "u"), std::pair("²", "^2"), std::pair("³", "^3"),
          std::pair("°", " deg")})
        text.replace(QString::fromUtf8(from), QString::fromUtf8(to));
    return text.trimmed();
}

/// "0.5 – 40 m", "(0, 1]", "> 0"; none for words.
std::optional<Range> rangeOf(const std::string& cell, Quantity quantity) {
    QString text = asTyped(cell);
    if (text.isEmpty()) return std::nullopt;
    Range range{0, std::numeric_limits<double>::infinity()};
    QString low, high;
    if (text.startsWith(u'>') || text.startsWith(u'≥')) {
        range.lowOpen = text.startsWith(u'>');
        low = text.mid(1);
    } else if (text.contains(u',')) {
        range.lowOpen = text.startsWith(u'(');
        range.highOpen = text.endsWith(u')');
        low = text.section(u',', 0, 0).mid(1);
        high = text.section(u',', 1).chopped(1);
    } else {
        low = text.section(QStringLiteral(" – "), 0, 0);
        high = text.section(QStringLiteral(" – "), 1);
        if (high.isEmpty()) return std::nullopt;
    }
    const Unit* unit = &unitsOf(quantity).front();
    const auto read = [&unit, quantity](const QString& end) {
        const TypedQuantity typed =
            parseQuantity(end.trimmed().toStdString(), quantity, BareNumber::inDefaultUnit, unit);
        if (typed.valid()) unit = typed.unit;
        return typed.valid() ? typed.si : std::numeric_limits<double>::quiet_NaN();
    };
    if (!high.isEmpty()) range.high = read(high);
    range.low = read(low);
    return std::isnan(range.low) || std::isnan(range.high) ? std::nullopt : std::optional(range);
}

bool isSame(const Range& a, const Range& b) {
    // units are exact to rounding
    const auto isNear = [](double x, double y) { return x == y || std::abs(x - y) <= 1e-12 * std::abs(y); };
    return isNear(a.low, b.low) && isNear(a.high, b.high) && a.lowOpen == b.lowOpen &&
           a.highOpen == b.highOpen;
}

QByteArray said(std::string_view key, const char* what, const std::string& cell) {
    return QByteArray(key.data(), qsizetype(key.size())) + ": " + what + " is told as " +
           QByteArray::fromStdString(cell);
}

/// Checks symbol and ranges of a row against a table; counts the ranges that are given in numbers.
template <class Row>
void compare(std::map<std::string, std::string>& told, const Row& row, int& compared) {
    QVERIFY2(told["symbol"] == row.symbol || told["symbol"].find(row.symbol) != std::string::npos,
             said(row.key, "the symbol", told["symbol"]));
    if (const std::optional<Range> hard = rangeOf(told["range"], row.quantity)) {
        QVERIFY2(isSame(*hard, row.hard), said(row.key, "the range", told["range"]));
        ++compared;
    }
    if (const std::optional<Range> usual = rangeOf(told["usual"], row.quantity)) {
        QVERIFY2(isSame(*usual, row.plausible), said(row.key, "what is usual", told["usual"]));
        ++compared;
    }
}

}  // namespace

class TestManualTables : public QObject {
    Q_OBJECT

  private slots:
    void parametersAreToldWithTheRangesTheyHave();
    void sectionsAreToldWithTheRangesTheyHave();
    void outputsAreToldInTheirUnits();
    void everySymbolStandsInTheGlossary();
    void theGlossaryNamesWhatThereIs();
    void theReferencesHaveEveryRow();
};

void TestManualTables::parametersAreToldWithTheRangesTheyHave() {
    int compared = 0;
    for (auto& row : rowsOf("files", {"key", "symbol", "range", "usual"})) {
        const std::vector<std::string_view> keys = codeIn(row["first"]);
        for (const std::string_view key : keys) {
            const KeptParameter parameter = findParameter(key);
            if (!parameter) continue;  // a word
            if (keys.size() > 1) row["symbol"] = std::string(parameter->symbol);
            // Two rows in one tell them one after the other.
            if (keys.size() == 1) compare(row, *parameter, compared);
        }
    }
    // 33 rows of one key, whose ranges are numbers but for some words
    QVERIFY2(compared >= 50, QByteArray::number(compared));
}

void TestManualTables::sectionsAreToldWithTheRangesTheyHave() {
    int compared = 0;
    for (auto& row : rowsOf("files", {"key of a section", "range", "usual"})) {
        const std::vector<std::string_view> keys = codeIn(row["first"]);
        QCOMPARE(keys.size(), 1U);
        if (const SectionField* field = findSectionField(keys.front())) compare(row, *field, compared);
    }
    // The ranges of the two areas are in units that files do not have.
    QCOMPARE(compared, 2 * int(sectionFields().size()) - 2);
}

void TestManualTables::outputsAreToldInTheirUnits() {
    std::set<std::string_view> told;
    for (auto& row : rowsOf("files", {"name", "meaning", "dimensionless unit", "SI"}))
        for (const std::string_view name : codeIn(row["name"])) {
            const Output* output = findOutput(name);
            QVERIFY2(output, said(name, "an output that is none", {}));
            told.insert(output->name);
            const std::string &scale = row["dimensionless unit"], &si = row["SI"];
            const bool isShare = si.starts_with("fraction of");
            const bool ofHammer = scale == "E0" || scale == "p0" || scale == "v0";
            QVERIFY2(isShare || ofHammer || scale == (output->isOnlySi() ? "SI only" : scaleName(*output)),
                     said(name, "the scale", scale));
            QVERIFY2(isShare || si == siName(*output), said(name, "the unit", si));
        }
    QCOMPARE(told.size(), outputs().size() + drillOutputs().size());
}

void TestManualTables::everySymbolStandsInTheGlossary() {
    std::set<std::string> symbols;
    for (auto& row : rowsOf("glossary", {"symbol", "what it is"}))
        for (const QString& each : QString::fromStdString(row["symbol"]).split(QStringLiteral(", ")))
            symbols.insert(each.toStdString());
    QVERIFY(symbols.size() > 40);
    for (const Parameter& parameter : parameters())
        if (!parameter.symbol.empty())
            QVERIFY2(symbols.contains(std::string(parameter.symbol)), parameter.symbol.data());
    for (const SectionField& field : sectionFields())
        if (!field.symbol.empty()) QVERIFY2(symbols.contains(std::string(field.symbol)), field.symbol.data());
}

void TestManualTables::theGlossaryNamesWhatThereIs() {
    for (auto& row : rowsOf("glossary", {"symbol", "name in files"}))
        for (const std::string_view name : codeIn(row["name in files"])) {
            const KeptParameter parameter = findParameter(name);
            QVERIFY2(parameter || findOutput(name) || findSectionField(name),
                     said(name, "what is not there", {}));
            if (parameter && row.contains("unit")) {
                const std::string_view si = unitsOf(parameter->quantity).front().name;
                const QString unit = asTyped(row["unit"] == "–" ? std::string() : row["unit"]);
                QCOMPARE(unit.section(QStringLiteral(", "), 0, 0).toStdString(), std::string(si));
            }
        }
}

void TestManualTables::theReferencesHaveEveryRow() {
    const std::vector<ManualBlock> entries = readMarkdown(findChapter(englishManual(), "parameters")->text);
    const auto has = [](const std::vector<ManualBlock>& blocks, std::string_view name) {
        return std::ranges::any_of(blocks, [name](const ManualBlock& block) {
            return block.kind == ManualBlock::Kind::heading &&
                   block.text.starts_with("`" + std::string(name) + "`: ");
        });
    };
    for (const Parameter& parameter : parameters())
        QVERIFY2(has(entries, parameter.key), parameter.key.data());
    for (const SectionField& field : sectionFields())
        QVERIFY2(has(entries, "string.NAME." + std::string(field.key)), field.key.data());
    const std::vector<ManualBlock> results = readMarkdown(findChapter(englishManual(), "outputs")->text);
    for (const auto table : {outputs(), drillOutputs()})
        for (const Output& output : table) QVERIFY2(has(results, output.name), output.name.data());
}

QTEST_APPLESS_MAIN(TestManualTables)
#include "tst_manual_tables.moc"
