// SPDX-License-Identifier: GPL-3.0-or-later
// Measured curves: each change a step of the history of the document, of which its file knows nothing.
#include <QSignalSpy>
#include <QTest>

#include "ui/document/document.h"
#include "ui/document/measured_list.h"

using namespace drillwave;

namespace {

MeasuredSignal signalOf(const char* name) {
    MeasuredSignal signal;
    signal.name = name;
    signal.points = TablePoints{{0, 0}, {1e-3, 5e3}};
    return signal;
}

}  // namespace

class TestMeasuredList : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void eachChangeIsUndoneByName();
    void whatIsBackStandsWhereItStood();
    void shiftsOfOneGestureAreOneStep();
    void nothingIsNoStep();
    void theScenarioIsNotModifiedByThem();
    void stepsOfTheScenarioBetweenThemCount();
    void emptyingAFieldLooksAtNoMeasuredStep();
    void theyOutliveTheHistory();

  private:
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const MeasuredSignal& signal : m_list->signalList()) names.push_back(signal.name);
        return names;
    }
    QUndoStack& history() { return m_document->undoStack(); }
    void changeScenario() {
        m_document->assign(*findParameter("bit_rock.gamma"), 0.2, m_document->newGesture());
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<MeasuredList> m_list;
};

using Names = std::vector<std::string>;

void TestMeasuredList::init() {
    m_list.reset();
    m_document = std::make_unique<Document>();
    m_document->start();
    m_list = std::make_unique<MeasuredList>(history());
}

void TestMeasuredList::eachChangeIsUndoneByName() {
    QSignalSpy changes(m_list.get(), &MeasuredList::changed);
    m_list->add(signalOf("gauge"));
    m_list->setTimeShift(0, 1e-4);
    m_list->remove(0);
    QCOMPARE(names(), Names());
    QCOMPARE(changes.count(), 3);
    QCOMPARE(history().undoText(), QStringLiteral("remove the measured curve gauge"));
    history().undo();
    QCOMPARE(names(), Names{"gauge"});
    QCOMPARE(m_list->signalList()[0].timeShift, 1e-4);
    QCOMPARE(history().undoText(), QStringLiteral("shift the measured curve gauge"));
    history().undo();
    QCOMPARE(m_list->signalList()[0].timeShift, 0.0);
    QCOMPARE(history().undoText(), QStringLiteral("lay over the measured curve gauge"));
    history().undo();
    QCOMPARE(names(), Names());
    QCOMPARE(changes.count(), 6);
    history().redo();
    QCOMPARE(names(), Names{"gauge"});
}

void TestMeasuredList::whatIsBackStandsWhereItStood() {
    for (const char* name : {"a", "b", "c"}) m_list->add(signalOf(name));
    const TablePoints points = m_list->signalList()[1].points;
    m_list->remove(1);
    QCOMPARE(names(), (Names{"a", "c"}));
    history().undo();
    QCOMPARE(names(), (Names{"a", "b", "c"}));
    QVERIFY(m_list->signalList()[1].points.isSharedWith(points));
}

void TestMeasuredList::shiftsOfOneGestureAreOneStep() {
    m_list->add(signalOf("gauge"));
    const int before = history().count();
    for (const double shift : {1e-6, 2e-6, 3e-6}) m_list->setTimeShift(0, shift, 7);
    QCOMPARE(history().count(), before + 1);
    m_list->setTimeShift(0, 9e-6, 8);
    m_list->setTimeShift(0, 10e-6);
    m_list->setTimeShift(0, 11e-6);
    QCOMPARE(history().count(), before + 4);
    for (const double shift : {10e-6, 9e-6, 3e-6, 0.0}) {
        history().undo();
        QCOMPARE(m_list->signalList()[0].timeShift, shift);
    }
    // There and back again is none.
    m_list->setTimeShift(0, 1e-6, 9);
    m_list->setTimeShift(0, 0, 9);
    QCOMPARE(history().index(), before);
}

void TestMeasuredList::nothingIsNoStep() {
    m_list->remove(0);
    m_list->setTimeShift(0, 1);
    m_list->add(signalOf("gauge"));
    const int before = history().count();
    m_list->setTimeShift(0, 0);
    m_list->setTimeShift(0, HUGE_VAL);
    QCOMPARE(history().count(), before);
}

void TestMeasuredList::theScenarioIsNotModifiedByThem() {
    m_list->add(signalOf("gauge"));
    QVERIFY(!m_document->isModified());
    changeScenario();
    QVERIFY(m_document->isModified());
    history().undo();
    QVERIFY(!m_document->isModified());
    history().undo();
    QVERIFY(!m_document->isModified());
    m_document->markUnsaved();
    QVERIFY(m_document->isModified());
}

// A step is announced before the history has it.
void TestMeasuredList::stepsOfTheScenarioBetweenThemCount() {
    QVector<bool> states;
    const QObject here;
    connect(m_document.get(), &Document::stateChanged, &here,
            [&] { states.append(m_document->isModified()); });
    m_list->add(signalOf("gauge"));
    changeScenario();
    QVERIFY(states.last());
    m_list->remove(0);
    QVERIFY(states.last());
    history().undo();
    history().undo();
    QVERIFY(!states.last());
}

void TestMeasuredList::emptyingAFieldLooksAtNoMeasuredStep() {
    m_list->add(signalOf("gauge"));
    const Scenario before = m_document->scenario();
    m_document->clear(*findParameter("rod.length"), 1);
    QCOMPARE(m_document->scenario(), before);
}

void TestMeasuredList::theyOutliveTheHistory() {
    m_list->add(signalOf("gauge"));
    m_document->start();
    QVERIFY(!history().canUndo());
    QCOMPARE(names(), Names{"gauge"});
    m_list->remove(0);
    history().undo();
    QCOMPARE(names(), Names{"gauge"});
}

QTEST_GUILESS_MAIN(TestMeasuredList)
#include "tst_measured_list.moc"
