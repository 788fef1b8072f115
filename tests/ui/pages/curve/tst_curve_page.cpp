// SPDX-License-Identifier: GPL-3.0-or-later
// The page COR–stiffness: the numbers of the study, one undo step a click, nothing out of sight.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QProcess>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

#include "core/model/section_parameter.h"
#include "core/report/curve_figure.h"
#include "core/report/curve_report.h"
#include "core/yaml/examples.h"
#include "tests/support/curve_page_fixture.h"
#include "tests/support/page_words.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/family_fields.h"
#include "ui/pages/study/output_box.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/shown_text.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

QStringList bandNames(const CurvePage& page) {
    QStringList names;
    for (const FigureBand& band : panelOf(page).bands) names << translated(band.name);
    return names;
}

}  // namespace

class TestCurvePage : public QObject, private CurvePageFixture {
    Q_OBJECT

  private slots:
    void init() { start(); }
    void theNumbersAreThoseOfTheStudy();
    void theFileIsThatOfTheCommand_data();
    void theFileIsThatOfTheCommand();
    void outOfSightNothingIsComputed();
    void aDragOfWhatIsVariedAsksNothing();
    void whereTheScenarioIsFollowsTheBlow();
    void aClickOnACurveIsOneUndoStep();
    void aClickNearAMarkTakesItsPlace();
    void theScenarioHasItsOwnCurve();
    void referencesHaveTheirLeastReboundWhereThePaperHasIt();
    void referencesOfScenariosWithUnitsStandAtTheirStiffness();
    void theClosedFormEndsWithItsDomain();
    void presetsAreNamedWhereTheyLie();
    void namesOfPresetsKeepOffEachOther_data();
    void namesOfPresetsKeepOffEachOther();
    void theTableReadsTheCurveOfTheScenario();
    void whatCannotBeStudiedIsSaid();
    void aRangeThatCannotBeFollowedShowsNoCurve_data();
    void aRangeThatCannotBeFollowedShowsNoCurve();
    void familiesOutOfRangeAreSaid();
    void whatTakesAStudyAtEveryPointIsNotOffered();
    void anotherValueOfTheFamilyIsThisScenario();
    void otherUnitsAreShownWithoutAnotherStudy();
    void aStudyBeforeItsBlowIsShownInItsOwnScales();
    void presetsAreReadAsThePageIsShown();
    void aStringIsAskedForItsEfficiencyOverTheRock();
    void sectionsOfAStringAreOffered();
    void theFileOfAStringIsThatOfTheCommand_data();
    void theFileOfAStringIsThatOfTheCommand();
    void rodsOfAStringAreWholeNumbers();
    void rangesAroundSectionsAreOnesThatTheyCanTake();
    void aPinnedRodIsLaidOverAString();
    void theFormOfTheScenarioIsFollowedBack();

  private:
    void openExample(const char* name) { open(std::string(findExample(name)->text).c_str()); }
    void openString() { openExample("t38_string"); }
    void varyBy(const char* key);
    /// Errors first, where they are not wanted apart.
    QByteArray outputOf(const QString& command, QByteArray* errors = nullptr);
    void showPage();
    const QCPGraph* graphOf(double family) const;
    const ComparedCurve& study() const { return *m_page->study().value(); }
};

void TestCurvePage::showPage() {
    showIn(naturalUnits(m_document->scenario()));
}

void TestCurvePage::theNumbersAreThoseOfTheStudy() {
    openElastic();
    showPage();
    const CurveQuestion& asked = study().question.curve;
    QCOMPARE(asked.along.key(), std::string_view("beta"));
    const CurveStudy direct = studyCurve(asked, 1);
    QCOMPARE(study().curve.lines.size(), direct.lines.size());
    for (std::size_t line = 0; line < direct.lines.size(); ++line) {
        QVERIFY(study().curve.lines[line].values == direct.lines[line].values);
        QVERIFY(study().curve.lines[line].outputs[0].features == direct.lines[line].outputs[0].features);
    }
    // dimensionless e is shown as it is
    const QVector<QCPGraph*> graphs = graphsOf(*m_page);
    QVERIFY(graphs.size() >= int(direct.lines.size()));
    for (int i = 0; i < int(direct.lines.size()); ++i)
        for (int n = 0; n < graphs[i]->dataCount(); ++n)
            QCOMPARE(graphs[i]->data()->at(n)->value, direct.lines[std::size_t(i)].values[0][std::size_t(n)]);
}

void TestCurvePage::theFileIsThatOfTheCommand_data() {
    QTest::addColumn<bool>("dimensional");
    QTest::newRow("groups") << false;
    QTest::newRow("units") << true;
}

void TestCurvePage::theFileIsThatOfTheCommand() {
    QFETCH(bool, dimensional);
    if (!dimensional) openElastic();
    if (dimensional) m_page->output()->setOutput(*findOutput("peak_force"));
    showPage();
    if (dimensional) m_page->output()->setOutput(*findOutput("peak_force"));
    finish();
    const QString command = m_page->command();
    QVERIFY2(command.startsWith("drillwave curve"), qPrintable(command));
    QByteArray errors;
    const QByteArray written = outputOf(command, &errors);
    QCOMPARE(errors, QByteArray());
    QVERIFY(written.size() > 10000);
    QCOMPARE(m_page->exports().first().csv(), written);
}

void TestCurvePage::outOfSightNothingIsComputed() {
    for (const double stiffness : {2e8, 3e8})
        m_document->assign(*findParameter("rod.length"), stiffness / 1e8, m_document->newGesture());
    m_page->setResult(solved(*m_document));
    QCOMPARE(m_page->study().started(), 0);
    showPage();
    QCOMPARE(m_page->study().started(), 1);
    m_page->hide();
    m_document->assign(*findParameter("rod.length"), 4, m_document->newGesture());
    m_page->setResult(solved(*m_document));
    QCOMPARE(m_page->study().started(), 1);
}

void TestCurvePage::aDragOfWhatIsVariedAsksNothing() {
    showPage();
    for (const double stiffness : {1.2e8, 1.4e8, 1.6e8})
        m_document->assign(*findParameter("bit_rock.stiffness"), stiffness, m_document->newGesture());
    QCOMPARE(m_page->study().started(), 1);
    m_document->assign(*findParameter("rod.length"), 4, m_document->newGesture());
    QCOMPARE(m_page->study().started(), 2);
    finish();
}

void TestCurvePage::whereTheScenarioIsFollowsTheBlow() {
    showPage();
    m_document->assign(*findParameter("bit_rock.stiffness"), 2e8, m_document->newGesture());
    m_page->setResult(solved(*m_document));
    const auto* here = m_page->plot()->findChild<HereMark*>();
    QVERIFY(here && here->x() && here->y());
    QVERIFY(std::abs(*here->x() - 200) < 1e-9);  // MN/m
    const CurveLine& own = *markedLine(study().curve, m_document->scenario().bitRock.gamma);
    QVERIFY(std::abs(*here->y() - *own.value(2e8, 0)) < 1e-9);
}

void TestCurvePage::aClickOnACurveIsOneUndoStep() {
    showPage();
    const QUndoStack& undo = m_document->undoStack();
    const int before = undo.count();
    const QCPGraph* elastic = graphOf(1);
    QVERIFY(elastic);
    // by value: the click draws other curves
    const QCPGraphData point = *elastic->data()->at(elastic->dataCount() / 2);
    QCPAxisRect* axes = elastic->keyAxis()->axisRect();
    emit m_page->plot()->placeTaken(axes, {point.key, point.value}, Qt::NoModifier);
    QCOMPARE(undo.count(), before + 1);
    QVERIFY(undo.undoText().contains("stiffness"));
    QCOMPARE(m_document->scenario().bitRock.gamma, 1.0);
    // four digits of what is under the pointer
    QVERIFY(std::abs(m_document->scenario().bitRock.stiffness / (point.key * 1e6) - 1) < 1e-3);
    m_document->undoStack().undo();
    QCOMPARE(m_document->scenario().bitRock.gamma, 0.1);
    // away from all curves only the parameter is taken
    emit m_page->plot()->placeTaken(axes, {150, 1e6}, Qt::NoModifier);
    QCOMPARE(m_document->scenario().bitRock.stiffness, 1.5e8);
    QCOMPARE(m_document->scenario().bitRock.gamma, 0.1);
    finish();
}

void TestCurvePage::aClickNearAMarkTakesItsPlace() {
    openElastic();
    showPage();
    const CurveFeature* largest = study().curve.lines.back().outputs[0].extreme(CurveFeature::Kind::maximum);
    QVERIFY(largest);
    const FigureFrame::Target target =
        m_page->figureFrame().targetAt({largest->x.value * 1.002, largest->value.value});
    QCOMPARE(target.x, largest->x.value);
    emit m_page->plot()->placeTaken(nullptr, {largest->x.value * 1.002, largest->value.value},
                                    Qt::NoModifier);
    QCOMPARE(m_document->scenario().groups.beta, largest->x.value);
    finish();
}

void TestCurvePage::theScenarioHasItsOwnCurve() {
    m_document->assign(*findParameter("bit_rock.gamma"), 0.2, m_document->newGesture());
    showPage();
    QCOMPARE(study().curve.lines.size(), 5u);
    QCOMPARE(*study().curve.lines.back().family, 0.2);
    const StudyPanel panel = panelOf(*m_page);
    QCOMPARE(panel.series[panel.marked].stroke, SeriesStroke::wide);
    m_page->findChild<QCheckBox*>("own")->setChecked(false);
    finish();
    QCOMPARE(study().curve.lines.size(), 4u);
}

/// Half a unit of the last digit in theory §7.
void TestCurvePage::referencesHaveTheirLeastReboundWhereThePaperHasIt() {
    openElastic();
    showPage();
    m_page->findChild<QComboBox*>("reference")->setCurrentIndex(1);
    finish();
    QVERIFY(study().reference);
    const CurveFeature* least =
        study().reference->lines.back().outputs[0].extreme(CurveFeature::Kind::minimum);
    QVERIFY(std::abs(least->x.value - 2.57847) < 5e-6 && std::abs(least->value.value - 0.9710054) < 5e-8);
    m_page->findChild<QComboBox*>("reference")->setCurrentIndex(2);
    finish();
    // over k0 = Z/t0 it is at a twentieth: τ = 10
    QVERIFY(std::abs(*study().reference->lines.back().value(2.57847 / 20, 0) - 0.9710054) < 5e-8);
}

void TestCurvePage::referencesOfScenariosWithUnitsStandAtTheirStiffness() {
    showPage();
    m_page->findChild<QComboBox*>("reference")->setCurrentIndex(2);
    finish();
    const StudyPanel panel = panelOf(*m_page);
    const auto elastic = std::ranges::find_if(panel.series, [](const FigureSeries& series) {
        return series.stroke == SeriesStroke::dotted && static_cast<int>(series.role) == 3;
    });
    QVERIFY(elastic != panel.series.end());
    // the same rod without waves by its own scenario
    Scenario scenario = m_document->scenario();
    scenario.pulse.shape = PulseShape::rigidBody;
    scenario.bitRock.gamma = 1;
    const std::size_t middle = elastic->x.size() / 2;
    scenario.bitRock.stiffness = elastic->x[middle];
    const Blow blow = solveBlow(scenario, {}, Detail::cor);
    QVERIFY(std::abs(blow.summary.cor - elastic->y[middle]) < 1e-9);
}

void TestCurvePage::theClosedFormEndsWithItsDomain() {
    openElastic();
    showPage();
    m_page->findChild<QCheckBox*>("closedForm")->setChecked(true);
    finish();
    QCOMPARE(std::ranges::count(panelOf(*m_page).series, SeriesStroke::dashed, &FigureSeries::stroke),
             1);  // only γ = 1
    const CurveLine& closed = study().closedForm->lines.back();
    const CurveLine& exact = study().curve.lines.back();
    QVERIFY(!closed.value(0.06, 0) && closed.value(1, 0));
    // it neglects exp(−2τ), 2e-9
    QVERIFY(std::abs(*closed.value(1, 0) - *exact.value(1, 0)) < 1e-8);
}

void TestCurvePage::presetsAreNamedWhereTheyLie() {
    showPage();
    const StudyPanel panel = panelOf(*m_page);
    QVERIFY(panel.bands.size() >= 4);
    QCOMPARE(translated(panel.top->title), QString("β = k t₀ / Z"));
    for (const FigureBand& band : panel.bands) {
        QVERIFY(band.from <= *band.at && *band.at <= band.to && band.to < 1.2 * band.from);
        QVERIFY(!band.name.isEmpty());
    }
    openElastic();
    finish();
    m_page->setResult(solved(*m_document));
    QVERIFY(panelOf(*m_page).bands.empty());
}

void TestCurvePage::namesOfPresetsKeepOffEachOther_data() {
    QTest::addColumn<int>("width");
    for (const int width : {380, 600, 900}) QTest::addRow("%d", width) << width;
}

// Begins with the mechanism: names in turns of two rows, however near to each other.
void TestCurvePage::namesOfPresetsKeepOffEachOther() {
    QFETCH(int, width);
    m_page->resize(width, 600);
    showPage();
    QCustomPlot* plot = m_page->plot();
    const QStringList names = bandNames(*m_page);
    QVERIFY(names.size() >= 4);
    plot->replot();
    QVector<QRectF> taken;
    for (int i = 0; i < plot->itemCount(); ++i) {
        const auto* text = qobject_cast<QCPItemText*>(plot->item(i));
        if (!text || !text->visible() || !names.contains(text->text())) continue;
        const QRectF place(text->topLeft->pixelPosition(), text->bottomRight->pixelPosition());
        QVERIFY2(
            QRectF(plot->axisRects().first()->rect()).adjusted(-1, -1, 1, 1).contains(place),
            qPrintable(QStringLiteral("%1: %2 … %3").arg(text->text()).arg(place.left()).arg(place.right())));
        for (const QRectF& other : std::as_const(taken))
            QVERIFY2(!other.adjusted(1, 1, -1, -1).intersects(place), qPrintable(text->text()));
        taken.append(place);
    }
    QVERIFY(taken.size() >= 2);
}

void TestCurvePage::theTableReadsTheCurveOfTheScenario() {
    showPage();
    QVERIFY(m_page->plot()->graphCount() > 1);
    QVERIFY2(m_page->plot()->reader().graph()->name().contains(QStringLiteral("this scenario")),
             qPrintable(m_page->plot()->reader().graph()->name()));
    QCPGraph* other = m_page->plot()->graph(1);
    m_page->plot()->reader().setGraph(other);
    m_page->setResult(solved(*m_document));
    QCOMPARE(m_page->plot()->reader().graph(), other);
}

void TestCurvePage::whatCannotBeStudiedIsSaid() {
    showPage();
    StudyFamily family{findParameter("beta"), {1, 2}};
    m_page->family()->setFamily(family);
    QTRY_VERIFY(pageWords(*m_page).contains("set the same thing"));
    QCOMPARE(graphsOf(*m_page).size(), 0);
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    m_page->family()->setFamily({});
    finish();
    QCOMPARE(graphsOf(*m_page).size(), 1);
}

const QCPGraph* TestCurvePage::graphOf(double family) const {
    const QVector<QCPGraph*> graphs = graphsOf(*m_page);
    for (int i = 0; i < graphs.size(); ++i)
        if (study().curve.lines[std::size_t(i)].family == family) return graphs[i];
    return nullptr;
}

void TestCurvePage::aRangeThatCannotBeFollowedShowsNoCurve_data() {
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("stop");
    QTest::addColumn<QString>("problem");
    QTest::newRow("downwards") << 1e9 << 1e7 << "must end above its beginning";
    QTest::newRow("narrow") << 1e8 << 1.00001e8 << "too narrow";
}

void TestCurvePage::aRangeThatCannotBeFollowedShowsNoCurve() {
    QFETCH(double, start);
    QFETCH(double, stop);
    QFETCH(QString, problem);
    showPage();
    const StudyRange good = m_page->axis()->range();
    const qsizetype curves = graphsOf(*m_page).size();
    QVERIFY(curves > 1 && !m_page->command().isEmpty());
    m_page->axis()->setRange({good.parameter, start, stop, true});
    QVERIFY2(words().contains(problem), qPrintable(words()));
    const auto* message = m_page->plot()->findChild<PlotMessage*>();
    QVERIFY(message->item().visible() &&
            message->item().text().simplified().contains(problem.section(' ', 0, 1)));
    QVERIFY(graphsOf(*m_page).isEmpty());
    QVERIFY(m_page->command().isEmpty());
    for (const PageExport& each : m_page->exports()) QVERIFY(each.obstacle().contains(problem));
    // neither a blow nor a click brings the last curve back
    m_page->setResult(solved(*m_document));
    const int steps = m_document->undoStack().count();
    emit m_page->plot()->placeTaken(nullptr, {150, 1}, Qt::NoModifier);
    QVERIFY(graphsOf(*m_page).isEmpty());
    QCOMPARE(m_document->undoStack().count(), steps);
    QCOMPARE(m_page->study().started(), 1);
    m_page->axis()->setRange(good);
    QCOMPARE(graphsOf(*m_page).size(), curves);
    QVERIFY(!message->item().visible() && !words().contains(problem));
    QCOMPARE(m_page->exports().first().obstacle(), QString());
    QCOMPARE(m_page->study().started(), 1);
}

void TestCurvePage::familiesOutOfRangeAreSaid() {
    showPage();
    m_page->family()->setFamily({findParameter("bit_rock.gamma"), {0.5, 2}});
    QVERIFY2(words().contains("must be in (0, 1]"), qPrintable(words()));
    QVERIFY(graphsOf(*m_page).isEmpty());
    QVERIFY(m_page->command().isEmpty());
    QCOMPARE(m_page->study().started(), 1);
}

void TestCurvePage::whatTakesAStudyAtEveryPointIsNotOffered() {
    m_document->assign(*findParameter("drill.blow_frequency"), 50, m_document->newGesture());
    m_document->assign(*findParameter("drill.thrust"), 8e3, m_document->newGesture());
    showPage();
    OutputBox all;
    all.present(m_document->scenario());
    QVERIFY(all.findData("thrust_margin") >= 0);
    QCOMPARE(m_page->output()->findData("thrust_margin"), -1);
    QCOMPARE(m_page->output()->count(), all.count() - 1);
}

void TestCurvePage::anotherValueOfTheFamilyIsThisScenario() {
    showPage();
    QVERIFY(words().contains("0.1, this scenario"));
    m_document->assign(*findParameter("bit_rock.gamma"), 0.3, m_document->newGesture());
    m_page->setResult(solved(*m_document));
    QCOMPARE(m_page->study().started(), 1);
    QVERIFY2(words().contains("0.3, this scenario"), qPrintable(words()));
    QVERIFY(graphOf(0.3)->name().contains("this scenario"));
    // the curve that was the scenario's is another value now
    const QCPGraph* other = graphOf(0.1);
    QVERIFY(!other->name().contains("this scenario"));
    const auto point = other->data()->at(other->dataCount() / 2);
    emit m_page->plot()->placeTaken(other->keyAxis()->axisRect(), {point->key, point->value}, Qt::NoModifier);
    QCOMPARE(m_document->scenario().bitRock.gamma, 0.1);
}

void TestCurvePage::otherUnitsAreShownWithoutAnotherStudy() {
    showPage();
    m_page->output()->setOutput(*findOutput("peak_force"));
    finish();
    const auto unit = [this] { return m_page->figureFrame().yUnit().unit; };
    QCOMPARE(unit(), QString("kN"));
    const double before = graphOf(0.1)->data()->at(10)->value;
    const auto restore = qScopeGuard([this] { m_document->units().choose(UnitSystem::si); });
    m_document->units().choose(UnitSystem::us);
    m_page->setResult(solved(*m_document, UnitSystem::us));
    QCOMPARE(m_page->study().started(), 2);
    QVERIFY2(unit().startsWith("klbf") || unit().startsWith("kip") || unit().startsWith("lbf"),
             qPrintable(unit()));
    const double inPounds = before * 1e3 / 4.4482216152605;
    const double shown = graphOf(0.1)->data()->at(10)->value;
    const double factor = unit().startsWith("lbf") ? 1 : 1e-3;
    QVERIFY(std::abs(shown / (inPounds * factor) - 1) < 1e-12);
}

void TestCurvePage::aStudyBeforeItsBlowIsShownInItsOwnScales() {
    showPage();
    m_page->output()->setOutput(*findOutput("peak_force"));
    finish();
    const Scenario before = m_document->scenario();
    m_document->assign(*findParameter("pulse.duration"), 1.5 * before.pulse.duration,
                       m_document->newGesture());
    finish();
    QVERIFY(scalesOf(m_document->scenario()).force < 0.7 * scalesOf(before).force);
    const auto isInKilonewtons = [&] {
        const CurveLine& line = study().curve.lines[2];
        const QCPGraph* graph = graphOf(*line.family);
        return m_page->figureFrame().yUnit().unit == "kN" &&
               std::abs(graph->data()->at(10)->value / (line.values[0][10] * 1e-3) - 1) < 1e-12;
    };
    QCOMPARE(study().question.curve.base.pulse.duration, 1.5 * before.pulse.duration);
    QVERIFY(isInKilonewtons());
    m_page->setResult(solved(*m_document));
    QVERIFY(isInKilonewtons());
}

void TestCurvePage::presetsAreReadAsThePageIsShown() {
    showPage();
    QVERIFY(QDir().mkpath(PresetLibrary::folder()));
    QFile file(QDir(PresetLibrary::folder()).filePath("presets.yaml"));
    const auto remove = qScopeGuard([&] { file.remove(); });
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "drillwave_presets: 1\nrocks:\n  - name: my own rock\n    stiffness: [123 MN/m, \"assumed\"]\n    "
        "gamma: [0.1, \"assumed\"]\n");
    file.close();
    // no disk while something is dragged
    m_document->assign(*findParameter("rod.length"), 4, m_document->newGesture());
    finish();
    m_page->setResult(solved(*m_document));
    QVERIFY(!bandNames(*m_page).join(' ').contains("my own rock"));
    m_page->hide();
    m_page->show();
    QVERIFY2(bandNames(*m_page).join(' ').contains("my own rock"), qPrintable(bandNames(*m_page).join(", ")));
    QCOMPARE(m_page->study().started(), 2);
}

// As by hand.
void TestCurvePage::varyBy(const char* key) {
    auto* box = m_page->axis()->findChild<QComboBox*>("parameter");
    QVERIFY2(box->findData(QLatin1String(key)) >= 0, key);
    box->setCurrentIndex(box->findData(QLatin1String(key)));
}

QByteArray TestCurvePage::outputOf(const QString& command, QByteArray* errors) {
    QProcess shell;
    QStringList path{QFileInfo(QStringLiteral(DRILLWAVE_PROGRAM)).path(), qEnvironmentVariable("PATH")};
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", path.join(':'));
    shell.setProcessEnvironment(environment);
    shell.start("/bin/sh", {"-c", command});
    if (!shell.waitForFinished(60000)) return "the command does not end";
    QByteArray problem = shell.readAllStandardError();
    if (errors) *errors = std::exchange(problem, {});
    return problem + shell.readAllStandardOutput();
}

void TestCurvePage::aStringIsAskedForItsEfficiencyOverTheRock() {
    QCOMPARE(m_page->title(), QStringLiteral("COR–stiffness"));
    openString();
    QCOMPARE(m_page->title(), QStringLiteral("Efficiency–stiffness"));
    showPage();
    const CurveQuestion& asked = study().question.curve;
    QCOMPARE(asked.along.key(), std::string_view("bit_rock.stiffness"));
    QCOMPARE(asked.along.kind, SweepAxis::Kind::logarithmic);
    QCOMPARE(asked.along.start, 1e7);
    QCOMPARE(asked.along.stop, 1e9);
    QVERIFY(!asked.family);
    QCOMPARE(asked.columns.front().output->name, std::string_view("efficiency"));
    const CurveLine& line = study().curve.lines.front();
    QCOMPARE(line.points.size(), std::size_t{101});
    // Logarithmically in the middle: the scenario itself, whose value the manual has.
    QVERIFY(std::abs(line.points[50] - 1e8) < 1);
    QVERIFY(std::abs(line.values.front()[50] - 0.316509329228) < 1e-7);
    for (const char* ofRods : {"reference", "closedForm"})
        QVERIFY2(m_page->findChild<QWidget*>(QLatin1String(ofRods))->isHidden(), ofRods);
    QVERIFY2(words().contains(QStringLiteral("101 points")), qPrintable(words()));
    QVERIFY(!bandNames(*m_page).isEmpty());  // rocks
    const auto* here = m_page->plot()->findChild<HereMark*>();
    QVERIFY(here && here->y() && std::abs(*here->y() - 0.316509329228) < 1e-7);
}

void TestCurvePage::sectionsOfAStringAreOffered() {
    openString();
    showPage();
    for (const char* key :
         {"string.coupling.diameter", "hammer.1.diameter", "hammer.velocity", "string.repeat"})
        varyBy(key);
    auto* box = m_page->axis()->findChild<QComboBox*>("parameter");
    QVERIFY(box->findData(QStringLiteral("rod.length")) < 0);
    QVERIFY(box->findData(QStringLiteral("pulse.duration")) < 0);
    finish();
}

void TestCurvePage::theFileOfAStringIsThatOfTheCommand_data() {
    QTest::addColumn<QString>("along");
    QTest::addColumn<QString>("output");
    QTest::addColumn<bool>("family");
    QTest::newRow("rock") << "bit_rock.stiffness"
                          << "efficiency" << false;
    QTest::newRow("a size, in SI") << "string.coupling.diameter"
                                   << "peak_force" << false;
    QTest::newRow("a blank in the name, a family") << "string.bit_skirt.diameter"
                                                   << "efficiency" << true;
}

void TestCurvePage::theFileOfAStringIsThatOfTheCommand() {
    QFETCH(QString, along);
    QFETCH(QString, output);
    QFETCH(bool, family);
    openString();
    auto* points = m_page->findChild<QComboBox*>("points");
    points->setCurrentIndex(points->findData(51));
    showPage();
    varyBy(along.toUtf8());
    m_page->output()->setOutput(*findOutput(output.toStdString()));
    if (family) m_page->family()->setFamily({findParameter("hammer.1.diameter"), {0.045, 0.05}});
    finish();
    const QString command = m_page->command();
    QVERIFY2(command.startsWith("drillwave sweep - --vary"), qPrintable(command));
    const QByteArray written = outputOf(command);
    QCOMPARE(written.count('\n'), family ? 1 + 2 * 51 : 1 + 51);
    QCOMPARE(m_page->exports().first().csv(), written);
}

void TestCurvePage::rodsOfAStringAreWholeNumbers() {
    openString();
    showPage();
    varyBy("string.repeat");
    finish();
    QCOMPARE(study().curve.lines.front().points, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    QVERIFY(!m_page->axis()->findChild<QCheckBox*>("logarithmic")->isEnabled());
    QCOMPARE(m_page->exports().first().csv(), outputOf(m_page->command()));
}

void TestCurvePage::rangesAroundSectionsAreOnesThatTheyCanTake() {
    for (const char* name : {"t38_string", "r32_string", "t51_string"}) {
        openExample(name);
        const Scenario& scenario = m_document->scenario();
        for (const KeptParameter& parameter : variableSectionParameters(scenario)) {
            const StudyRange range = rangeAround(*parameter, scenario);
            QVERIFY2(range.start < range.stop, std::string(parameter->key).c_str());
            const double value = *parameter->value(scenario);
            QVERIFY(range.start <= value && value <= range.stop);
            CurveQuestion question;
            question.base = scenario;
            question.along =
                parseAxis(range.text() + ":" + std::to_string(range.pointsWithin(101)) + range.tail()).axis;
            question.columns = {{findOutput("efficiency")}};
            const auto problems = sampledProblemsOf(question);
            QVERIFY2(problems.empty(),
                     (std::string(parameter->key) + ": " + (problems.empty() ? "" : problems.front().text()))
                         .c_str());
        }
    }
}

void TestCurvePage::aPinnedRodIsLaidOverAString() {
    Run rod;
    rod.number = 1;
    rod.contents = m_document->contents();
    rod.blow = solved(*m_document);
    openString();
    auto runs = std::make_shared<RunList>();
    runs->push_back(rod);
    m_page->setRuns(runs);
    showPage();
    QTRY_COMPARE(m_page->figureFrame().runCurves().size(), 1);
}

void TestCurvePage::theFormOfTheScenarioIsFollowedBack() {
    openString();
    showPage();
    openExample("t38_medium_rock");
    m_page->setResult(solved(*m_document));
    finish();
    QCOMPARE(m_page->title(), QStringLiteral("COR–stiffness"));
    QCOMPARE(study().question.curve.columns.front().output->name, std::string_view("cor"));
    QVERIFY(study().question.curve.family);
    QVERIFY(!m_page->findChild<QWidget*>("reference")->isHidden());
    QVERIFY(m_page->command().startsWith("drillwave curve"));
}

QTEST_MAIN(TestCurvePage)
#include "tst_curve_page.moc"
