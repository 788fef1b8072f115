// SPDX-License-Identifier: GPL-3.0-or-later
// Links from the result panel to the rest of the window, and back.
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "core/blow/blow_waves.h"
#include "core/model/alerts.h"
#include "core/yaml/examples.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/form/scenario_panel.h"
#include "ui/form/section_box.h"
#include "ui/job/observation.h"
#include "ui/pages/drilling/drilling_page.h"
#include "ui/pages/map/map_page.h"
#include "ui/result/alert_list.h"
#include "ui/result/result_panel.h"
#include "ui/result/result_row.h"
#include "ui/text/settings.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;
using namespace drillwave::test;

class TestResultWiring : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        keepSettingsIn(m_folder.path());
    }

    void anAlertLeadsToTheFieldOfItsParameter() {
        MainWindow window;
        window.setAttribute(Qt::WA_DontShowOnScreen);
        window.show();
        window.activateWindow();
        const Alert alert{AlertLevel::warning,
                          AlertCode::implausibleValue,
                          "bit_rock.gap",
                          {{"value", 1, Quantity::length}}};
        part<ResultPanel>(window).alerts()->present({}, {alert}, m_style);
        QLabel* label = nullptr;
        for (QLabel* each : part<ResultPanel>(window).alerts()->findChildren<QLabel*>())
            if (each->text().contains("href=\"bit_rock.gap\"")) label = each;
        QVERIFY(label);
        for (SectionBox* box : part<ScenarioPanel>(window).findChildren<SectionBox*>()) box->setOpen(false);
        QSignalSpy chosen(&part<ResultPanel>(window), &ResultPanel::parameterChosen);
        emit label->linkActivated(QStringLiteral("bit_rock.gap"));
        QCOMPARE(chosen.count(), 1);
        QWidget* field = part<ScenarioPanel>(window).findChild<QWidget*>(QStringLiteral("bit_rock.gap"));
        QVERIFY(field->isVisibleTo(&window));
        QCOMPARE(window.focusWidget() == field || field->isAncestorOf(window.focusWidget()), true);
    }

    // The list is the last of the panel, and in a small window the panel is behind the scenario.
    void theStatusLineCountsTheAlertsAndLeadsToThem() {
        MainWindow window;
        window.resize(1000, 650);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        auto& panel = part<ResultPanel>(window);
        QTRY_VERIFY(panel.visibleRegion().isEmpty());
        auto* link = window.findChild<AlertLink*>("alertLink");
        QVERIFY(link);
        panel.alerts()->present({}, {}, m_style);
        QVERIFY(link->isHidden());
        const Alert warning{AlertLevel::warning,
                            AlertCode::implausibleValue,
                            "rod.length",
                            {{"value", 1e3, Quantity::length}}};
        const Alert note{AlertLevel::information,
                         AlertCode::implausibleValue,
                         "bit_rock.gap",
                         {{"value", 1, Quantity::length}}};
        panel.alerts()->present({}, {note}, m_style);
        QCOMPARE(link->text(), QString("ℹ 1 note"));
        panel.alerts()->present({}, {note, warning}, m_style);
        QCOMPARE(link->text(), QString("⚠ 1 warning · ℹ 1 note"));
        QVERIFY(link->isVisibleTo(&window));
        for (const QString& text : panel.alerts()->texts())
            QVERIFY(link->toolTip().contains(text.toHtmlEscaped()));
        link->click();
        QTRY_VERIFY(!panel.visibleRegion().isEmpty());
        const QLabel& first = *panel.alerts()->findChildren<QLabel*>().first();
        QTRY_VERIFY(!first.visibleRegion().isEmpty());
        QCOMPARE(window.focusWidget(), &first);
        panel.alerts()->present("out of rock", {}, m_style);
        QCOMPARE(link->text(), QString("✖ not solved"));
    }

    // The estimate is of single blows; the page follows them.
    void theSequenceLeadsToItsPage() {
        MainWindow window;
        window.show();
        window.openExample(*findExample("t38_medium_rock"));
        auto* sequence = part<ResultPanel>(window).findChild<QLabel*>(QStringLiteral("sequence"));
        QVERIFY(sequence);
        QTRY_VERIFY(sequence->isVisibleTo(&window));
        emit sequence->linkActivated(QStringLiteral("drilling"));
        QCOMPARE(&part<PageTabs>(window).current(), &part<DrillingPage>(window));
        window.openExample(*findExample("paper_fig4b"));
        QTRY_VERIFY(!sequence->isVisibleTo(&window));
    }

    void alertsAreInViewAboveTheNumbers() {
        ResultPanel panel;
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        panel.resize(360, 500);
        panel.show();
        panel.alerts()->present({}, {}, m_style);
        const QLabel& first = *panel.alerts()->findChildren<QLabel*>().first();
        QTRY_VERIFY(!first.visibleRegion().isEmpty());
        const auto* stress = panel.findChild<SectionBox*>(QStringLiteral("stress"));
        QVERIFY(!stress->isOpen());
        QVERIFY(stress->mapTo(&panel, QPoint()).y() > first.mapTo(&panel, QPoint()).y());
    }

    void aLargestStressLeadsToItsPlaceOnPagesThatShowOne() {
        MainWindow window;
        window.setAttribute(Qt::WA_DontShowOnScreen);
        window.show();
        auto& pages = part<PageTabs>(window);
        PlaceLink* tension = part<ResultPanel>(window).findChildren<PlaceLink*>().at(1);
        const RodForce& force = window.shown()->summary.rodForces->tension;
        emit tension->followed();
        QCOMPARE(part<Observation>(window).section(), force.section);
        QCOMPARE(part<Observation>(window).time(), std::optional(force.time));
        QCOMPARE(pages.current().title(), QString("Blow"));
        pages.setCurrentWidget(&part<MapPage>(window));
        emit tension->followed();
        QCOMPARE(pages.current().title(), QString("Rod"));
    }

    // A click leads to the place and the time, in the hammer too, and the stress there is that of the panel.
    void aLargestStressOfAStringLeadsToItsPlace() {
        MainWindow window;
        window.setAttribute(Qt::WA_DontShowOnScreen);
        window.show();
        const auto titles = [&] {
            QStringList all;
            for (const SectionBox* box : part<ResultPanel>(window).findChildren<SectionBox*>())
                all << box->title();
            return all;
        };
        QVERIFY(titles().contains(QString("Stress in the rod")));
        window.document().startFrom(findExample("t38_string")->text, QStringLiteral("t38_string"));
        QTRY_VERIFY(window.shown()->isOfString() && window.shown()->isSolved());
        QVERIFY(titles().contains(QString("Stress in hammer and string")));
        const Blow& blow = *window.shown();
        const Observation& observation = part<Observation>(window);
        const std::vector<SectionStress> stresses = sectionStresses(blow.scenario, blow.impact);
        const auto links = part<ResultPanel>(window).findChildren<PlaceLink*>();
        emit links.at(1)->followed();
        const StringPeak peak = largestStress(stresses, Load::tension);
        QCOMPARE(observation.time(), std::optional(peak.peak.time / blow.scales.time));
        const StringPlace place = stringPlace(blow.scenario.drillString, observation.section());
        QCOMPARE(place.section, peak.section);
        QVERIFY(links.at(1)->text().contains(QStringLiteral("from the struck end")));
        // The next blow is one whose hammer is loaded most.
        window.document().assign(*findParameter("hammer.2.diameter"), 0.03, window.document().newGesture());
        QTRY_COMPARE(window.shown()->scenario.drillString.hammer.sections[1].diameter, 0.03);
        emit links.at(0)->followed();
        QVERIFY2(observation.section() < 0, qPrintable(QString::number(observation.section())));
        QVERIFY(links.at(0)->text().startsWith(QStringLiteral("in the hammer")));
        // A rod has no place there.
        window.document().startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
        QCOMPARE(observation.section(), 0.0);
        QTRY_VERIFY(!window.shown()->isOfString());
    }

    void theTimeCursorOfTheWindowMarksTheEvent() {
        MainWindow window;
        QTableView& events = *part<ResultPanel>(window).findChild<QTableView*>();
        const double time = window.shown()->impact.events.at(1).time;
        part<Observation>(window).setTime(time);
        QCOMPARE(events.currentIndex().row(), 1);
        events.setCurrentIndex(events.model()->index(0, 0));
        QCOMPARE(*part<Observation>(window).time(), window.shown()->impact.events.at(0).time);
    }

  private:
    QTemporaryDir m_folder;
    const LocalStyle m_style{QLocale::c(), UnitSystem::si, {}};
};

QTEST_MAIN(TestResultWiring)
#include "tst_result_wiring.moc"
