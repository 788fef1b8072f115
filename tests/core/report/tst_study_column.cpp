// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of a study: the same numbers for people, in CSV and in JSON, and nothing where there is none.
#include <QTest>

#include <array>
#include <limits>

#include "core/report/study_column.h"
#include "core/text/languages.h"

using namespace drillwave;

namespace {

struct Row {
    double error, time;
};

constexpr auto columns = std::to_array<StudyColumn<Row>>({
    {"error_cor", "error", NumberStyle::error, [](const Row& row) { return row.error; }},
    {"hidden", "", NumberStyle::count, [](const Row&) { return 3.0; }},
    {"median_s", "median", NumberStyle::time, [](const Row& row) { return row.time; }},
});

constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

class TestStudyColumn : public QObject {
    Q_OBJECT

  private slots:
    void peopleReadWhatHasATitle();
    void programsReadEveryColumn();
    void cellsAreWrittenSoThatTheyReadBack();
};

void TestStudyColumn::peopleReadWhatHasATitle() {
    QCOMPARE(withTitles("method", columns), (std::vector<std::string>{"method", "error", "median"}));
    QCOMPARE(withCells("exact", columns, Row{1.25e-7, 3e-6}),
             (std::vector<std::string>{"exact", "1.2e-07", "3 us"}));
    QCOMPARE(withCells("exact", columns, Row{none, 3e-6}), (std::vector<std::string>{"exact", "-", "3 us"}));
    QCOMPARE(withCells("exact", columns, Row{1.25e-7, 3.5e-6}, styleOf(*findLanguage("de"))),
             (std::vector<std::string>{"exact", "1,2e-07", "3,5 us"}));
}

void TestStudyColumn::programsReadEveryColumn() {
    std::vector<std::string> headers{"method"};
    appendKeys(headers, columns);
    const auto csv = [&](bool isSolved) {
        return csvText({headers, 1, [&](std::size_t) {
                            Cells cells{"exact"};
                            appendCells(cells, columns, Row{0.5, none}, isSolved);
                            return cells;
                        }});
    };
    QCOMPARE(csv(true), std::string("method,error_cor,hidden,median_s\nexact,0.5,3,\n"));
    QCOMPARE(csv(false), std::string("method,error_cor,hidden,median_s\nexact,,,\n"));
    JsonObject object;
    addMembers(object, columns, Row{0.5, none});
    QCOMPARE(Json(object).text(),
             std::string("{\n    \"error_cor\": 0.5,\n    \"hidden\": 3,\n    \"median_s\": null\n}\n"));
}

/// Words with commas, quotes or line ends are quoted; what is no finite number is nothing.
void TestStudyColumn::cellsAreWrittenSoThatTheyReadBack() {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::vector<Cells> rows{{1.5, 7, true, "hex, 25 mm"},
                                  {none, infinite, Cell(), "a \"b\""},
                                  {std::optional<double>(), std::optional(0.1)}};
    QCOMPARE(
        csvText({{"a", "b [mm, in]", "c", "d"}, rows.size(), [&](std::size_t row) { return rows[row]; }}),
        std::string("a,\"b [mm, in]\",c,d\n1.5,7,true,\"hex, 25 mm\"\n,,,\"a \"\"b\"\"\"\n,0.1,,\n"));
    QCOMPARE(csvText({{"a"}, 0, {}}), std::string("a\n"));
}

QTEST_GUILESS_MAIN(TestStudyColumn)
#include "tst_study_column.moc"
