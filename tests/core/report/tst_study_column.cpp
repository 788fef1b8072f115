// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of a study: the same numbers for people, in CSV and in JSON, and nothing where there is none.
#include <QTest>

#include <array>
#include <limits>

#include "core/report/study_column.h"
#include "core/text/language_style.h"

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
    void whatWasNotSolvedHasNoNumbers();
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
    std::string csv = "method";
    appendKeys(csv, columns);
    QCOMPARE(csv, std::string("method,error_cor,hidden,median_s"));
    std::string row;
    appendCells(row, columns, Row{0.5, none});
    QCOMPARE(row, std::string(",0.5,3,"));
    JsonObject object;
    addMembers(object, columns, Row{0.5, none});
    QCOMPARE(Json(object).text(),
             std::string("{\n    \"error_cor\": 0.5,\n    \"hidden\": 3,\n    \"median_s\": null\n}\n"));
}

void TestStudyColumn::whatWasNotSolvedHasNoNumbers() {
    std::string row;
    appendCells(row, columns, Row{0.5, 1}, false);
    QCOMPARE(row, std::string(",,,"));
}

QTEST_GUILESS_MAIN(TestStudyColumn)
#include "tst_study_column.moc"
