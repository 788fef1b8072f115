// SPDX-License-Identifier: GPL-3.0-or-later
// A study that is a value has all that studies have: command, help, completion, JSON, CSV, picture; page,
// cancel, pinned runs, a click with undo, and the copied command.
#include <fcntl.h>
#include <unistd.h>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "app/command.h"
#include "app/command_error.h"
#include "app/describe/completions.h"
#include "app/help_text.h"
#include "core/yaml/examples.h"
#include "tests/support/page_words.h"
#include "tests/support/pinned_run.h"
#include "tests/support/toy_study/toy_study.h"
#include "ui/export/study_pictures.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/figure_page.h"
#include "ui/plot/here_mark.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr const char* over = "pulse.duration=100us:300us";

/// Standard output as a file while it lives.
class CaughtOutput {
  public:
    explicit CaughtOutput(const QString& path) : m_before(::dup(STDOUT_FILENO)) {
        std::fflush(stdout);
        const int file = ::open(QFile::encodeName(path).constData(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(file, STDOUT_FILENO);
        ::close(file);
    }
    ~CaughtOutput() {
        std::fflush(stdout);
        ::dup2(m_before, STDOUT_FILENO);
        ::close(m_before);
    }

  private:
    int m_before;
};

/// Draws in this program, which is a window's already.
class StudyDrawing : public Drawing {
  public:
    std::string figure(const Figure&, std::string_view) const override { return {}; }
    std::vector<NamedFile> blow(const Blow&, const std::vector<std::string>&,
                                const std::stop_token&) const override {
        return {};
    }
    std::vector<NamedFile> report(const BlowReport&, const PictureOrder&) const override { return {}; }
    std::vector<NamedFile> study(const StudyValue& value, const PictureOrder& order) const override {
        return std::visit([&](const auto* found) { return drawStudy(*found, order).files; }, value);
    }
};

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestToyStudy : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void commandPrintsTextAndJson();
    void commandWritesCsvAndPicture();
    void wrongOptionIsRefusedWithItsName();
    void helpAndCompletionHaveTheOptions();
    void pageShowsFigureSentenceAndPlace();
    void csvOfThePageIsThatOfTheCopiedCommand();
    void clickTakesTheValueAsOneUndoStep();
    void pinnedRunIsLaidOverTheFigure();
    void hiddenPageStopsAndGoesOn();
    void groupOfOptionsIsGivenAsAWhole();
    void scenarioWithoutUnitsHasNoSuchPage();

  private:
    QByteArray printed(const std::vector<std::string>& words) const;
    void start(FigurePage& page) const;

    QTemporaryDir m_folder;
};

QByteArray TestToyStudy::printed(const std::vector<std::string>& words) const {
    const Command& command = *findCommand("toy");
    const Arguments arguments = parseArguments(command, words);
    const StudyDrawing drawing;
    const QString path = m_folder.filePath(QStringLiteral("printed"));
    {
        const CaughtOutput caught(path);
        if (command.run(arguments, &drawing) != ExitCode::done) return "failed";
    }
    return bytesOf(path);
}

void TestToyStudy::commandPrintsTextAndJson() {
    const QByteArray text = printed({"t38_medium_rock", "--over", over});
    QVERIFY2(text.startsWith("The largest force is ") && text.contains(" kN"), text.constData());
    const QByteArray json = printed({"t38_medium_rock", "--over", over, "--json"});
    QVERIFY2(json.contains("\"largest_force\": ") && json.contains("\"scenario\": "), json.constData());
}

void TestToyStudy::commandWritesCsvAndPicture() {
    const std::string csv = m_folder.filePath(QStringLiteral("t.csv")).toStdString();
    printed({"t38_medium_rock", "--over", over, "-o", csv, "--plots", "png"});
    const QByteArray table = bytesOf(QString::fromStdString(csv));
    QVERIFY(table.contains("\npulse.duration,peak_force,peak_force_other\n"));
    QCOMPARE(table.trimmed().split('\n').last().split(',').size(), 3);
    const QImage picture(m_folder.filePath(QStringLiteral("t.png")));
    QVERIFY(picture.width() > 1000);
}

void TestToyStudy::wrongOptionIsRefusedWithItsName() {
    const auto line = [&](const std::vector<std::string>& words) {
        try {
            printed(words);
        } catch (const CommandError& error) {
            return std::to_string(int(error.code())) + " " + error.lines().front();
        }
        return std::string();
    };
    QCOMPARE(line({"t38_medium_rock"}), std::string("2 needs --over KEY=START:STOP"));
    QCOMPARE(line({"t38_medium_rock", "--over", over, "--other-length", "-1m"}),
             std::string("5 --other-length = -1m (must be greater than 0)"));
    QVERIFY(line({"paper_fig4b", "--over", over}).starts_with("5 paper_fig4b: has no units"));
}

void TestToyStudy::helpAndCompletionHaveTheOptions() {
    const std::string help = commandHelp(*findCommand("toy"), styleOf(languages[0]));
    QVERIFY(help.find("--other-length LENGTH") != std::string::npos);
    QVERIFY(help.find("--decimal-comma") != std::string::npos);
    QVERIFY(bashCompletion().find("--over --other-length --json") != std::string::npos);
}

void TestToyStudy::start(FigurePage& page) const {
    page.resize(900, 600);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    QTRY_COMPARE_WITH_TIMEOUT(page.activity()->state(), StudyState::finished, 60000);
}

void TestToyStudy::pageShowsFigureSentenceAndPlace() {
    Document document;
    document.startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
    FigurePage page(toyStudy(), document);
    start(page);
    QCOMPARE(page.title(), QStringLiteral("Toy"));
    QCOMPARE(page.figureFrame().graph(0, 0)->dataCount(), 41);
    QCOMPARE(page.figureFrame().graph(0, 1)->name(), QStringLiteral("other length"));
    QVERIFY(pageWords(page).startsWith("The largest force is"));
    page.findChild<QPushButton*>(QStringLiteral("copyAnswer"))->click();
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("The largest force is")));
    QVERIFY(std::abs(*page.findChild<HereMark*>()->x() - document.scenario().pulse.duration * 1e6) < 1e-9);
    QVERIFY(page.figureFrame().graph()->keyAxis()->label().contains(QStringLiteral("µs")));
    QVERIFY(page.figureFrame().graph()->valueAxis()->label().contains(QStringLiteral("kN")));
}

void TestToyStudy::csvOfThePageIsThatOfTheCopiedCommand() {
    Document document;
    QVERIFY(document.open(QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/examples/t38_medium_rock.yaml"))
                .isEmpty());
    FigurePage page(toyStudy(), document);
    start(page);
    std::vector<std::string> words;
    for (const std::string& word : shellWords(page.command().toStdString())) words.push_back(word);
    QCOMPARE(words[1], std::string("toy"));
    QCOMPARE(page.exports().first().csv(), printed({words.begin() + 2, words.end()}));
}

void TestToyStudy::clickTakesTheValueAsOneUndoStep() {
    Document document;
    document.startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
    FigurePage page(toyStudy(), document);
    start(page);
    page.plot()->replot();
    const QCPGraph* curve = page.figureFrame().graph();
    const auto point = curve->data()->constBegin() + 10;
    const double before = document.scenario().pulse.duration;
    QTest::mouseClick(page.plot(), Qt::LeftButton, {},
                      curve->coordsToPixels(point->key, point->value).toPoint());
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(std::abs(document.scenario().pulse.duration * 1e6 / point->key - 1) < 0.02);
    document.undoStack().undo();
    QCOMPARE(document.scenario().pulse.duration, before);
}

void TestToyStudy::pinnedRunIsLaidOverTheFigure() {
    Document document;
    document.startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
    FigurePage page(toyStudy(), document);
    start(page);
    Scenario stiffer = document.scenario();
    stiffer.bitRock.stiffness *= 2;
    MethodSolver solver;
    SolveRequest request;
    request.scenario = stiffer;
    const SolvedBlowPtr blow = solveBlow(request, solver);
    page.setRuns(std::make_shared<const RunList>(RunList{pinnedRun(0, blow)}));
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 1, 60000);
    QCOMPARE(page.figureFrame().runCurves().front()->dataCount(), 41);
}

void TestToyStudy::hiddenPageStopsAndGoesOn() {
    Document document;
    document.startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
    FigurePage page(toyStudy(), document);
    page.show();
    QCOMPARE(page.activity()->state(), StudyState::running);
    page.hide();
    QCOMPARE(page.activity()->state(), StudyState::stopped);
    start(page);
    QCOMPARE(page.studies(), 2);
}

void TestToyStudy::groupOfOptionsIsGivenAsAWhole() {
    Document document;
    document.startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
    FigurePage page(toyStudy(), document);
    start(page);
    QVERIFY(!page.command().contains(QStringLiteral("--other-length")));
    page.findChild<QComboBox*>(QStringLiteral("other"))->setCurrentIndex(1);
    auto* field = page.findChild<QuantityField*>(QStringLiteral("other-length"));
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("6 m"));
    QVERIFY(page.command().contains(QStringLiteral("--other-length '6 m'")));
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("-6 m"));
    QVERIFY2(field->problem().contains(QStringLiteral("must be")), qPrintable(field->problem()));
    QTRY_COMPARE_WITH_TIMEOUT(page.activity()->state(), StudyState::finished, 60000);
}

void TestToyStudy::scenarioWithoutUnitsHasNoSuchPage() {
    Document document;
    FigurePage page(toyStudy(), document);
    QVERIFY(!page.shows(parseScenario(findExample("paper_fig4b")->text, "paper").scenario));
    QCOMPARE(page.elsewhere(), QStringLiteral("Toy is of scenarios in physical units."));
}

QTEST_MAIN(TestToyStudy)
#include "tst_toy_study.moc"
