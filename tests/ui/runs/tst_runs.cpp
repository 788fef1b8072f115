// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs: named by what changed, solved again, kept beside their file and read back.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/yaml/examples.h"
#include "tests/support/contrast.h"
#include "tests/support/files.h"
#include "tests/support/window.h"
#include "ui/plot/run_pen.h"
#include "ui/runs/difference_text.h"
#include "ui/runs/run_keeper.h"
#include "ui/runs/runs.h"
#include "ui/text/unit_choice.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

ScenarioDocument contentsOf(Document& document) {
    ScenarioDocument contents = document.contents();
    contents.text = document.text().toStdString();
    contents.source = QFile::encodeName(document.origin()).toStdString();
    return contents;
}

QStringList titles(const Runs& runs) {
    QStringList titles;
    for (const Run& run : *runs.list()) titles << run.title();
    return titles;
}

/// Writes nothing before a signal to go on.
class SlowDisk {
  public:
    RunKeeper::Write writer() {
        return [this](RunsFolder& folder, const std::vector<NamedFile>& files, ExistingFiles existing) {
            std::unique_lock hold(m_lock);
            ++m_writings;
            m_thread = std::this_thread::get_id();
            m_changed.notify_all();
            m_changed.wait(hold, [this] { return m_goesOn; });
            return folder.write(files, existing);
        };
    }
    void waitUntilItIsBusy() {
        std::unique_lock hold(m_lock);
        m_changed.wait(hold, [this] { return m_writings > 0; });
    }
    void goOn() {
        const std::lock_guard hold(m_lock);
        m_goesOn = true;
        m_changed.notify_all();
    }
    int writings() {
        const std::lock_guard hold(m_lock);
        return m_writings;
    }
    bool isOfThisThread() {
        const std::lock_guard hold(m_lock);
        return m_thread == std::this_thread::get_id();
    }

  private:
    std::mutex m_lock;
    std::condition_variable m_changed;
    int m_writings = 0;
    bool m_goesOn = false;
    std::thread::id m_thread;
};

}  // namespace

class TestRuns : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void aRunIsNamedByWhatChangedAgainstTheReference();
    void namesFollowTheUnitsOfTheFields();
    void lettersAreGivenAnew();
    void theSameResultIsPinnedOnce();
    void thereIsAnEndToThem();
    void withoutItsRunTheReferenceIsAnother();
    void whatHasNoBlowIsSolved();
    void undoLeavesThemAlone();
    void keptRunsComeBackWithTheirFile();
    void withoutRunsTheyAreKeptAsWell();
    void everyChangeIsWritten();
    void onlyWhatChangesIsWritten();
    void theDiskIsWaitedForBesideTheWindow();
    void whatCannotBeWrittenIsToldOnce();
    void whatIsLeftIsWrittenInTheEndAndNothingTold();
    void keptRunsGoAlongToANewName();
    void runsOfTheFileThatIsSavedOverAreAskedAbout();
    void othersStayWhenAnotherFileIsOpened();
    void aBrokenRunIsToldAndNotWrittenOver();
    void whatOthersPutIntoTheFolderIsNotWrittenOver();
    void lettersOfOtherFilesAreNotGiven();
    void aChangedTableIsTold();
    void tablesAreFoundFromAnotherFolder();
    void givenUpNothingIsLeft();
    void revertingBringsTheBytesBack();
    void savingLeavesEveryStepItsBytes();
    void reloadingIsAStepWithItsBytes();
    void everyRunHasAColourAndADashOfItsOwn();
    void differencesAreReadable();

  private:
    QString pin(const QString& title = QStringLiteral("first")) {
        return m_runs->pin(contentsOf(*m_document), nullptr, title);
    }
    void set(const char* key, double si) {
        QCOMPARE(m_document->assign(*findParameter(key), si, m_document->newGesture()), QString());
    }
    /// Kept, and written: why not.
    QString kept(ExistingFiles existing = ExistingFiles::kept) {
        const QString problem = m_keeper->keep(existing);
        return problem.isEmpty() ? m_keeper->finish() : problem;
    }
    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<RunKeeper> m_keeper;
    std::unique_ptr<RunSolver> m_solver;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Runs> m_runs;
};

void TestRuns::initTestCase() {
    QLocale::setDefault(QLocale::c());
}

void TestRuns::init() {
    m_keeper.reset();
    m_solver.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    keepSettingsIn(m_folder->path());
    m_runs.reset();
    m_document = std::make_unique<Document>();
    m_runs = std::make_unique<Runs>(m_document->units());
    m_document->startFrom(findExample("t38_medium_rock")->text, "example");
    m_keeper = std::make_unique<RunKeeper>(*m_document, *m_runs);
}

void TestRuns::aRunIsNamedByWhatChangedAgainstTheReference() {
    QCOMPARE(pin("T38"), QString());
    set("bit_rock.stiffness", 3e8);
    QCOMPARE(pin(), QString());
    set("rod.length", 3);
    QCOMPARE(pin(), QString());
    // Against the second from here on.
    m_runs->setReference(1);
    m_document->setShape(PulseShape::halfSine);
    QCOMPARE(pin(), QString());
    QCOMPARE(titles(*m_runs),
             QStringList({"A  T38", "B  k 300 MN/m", "C  L 3 m, k 300 MN/m", "D  half sine, L 3 m"}));
}

void TestRuns::namesFollowTheUnitsOfTheFields() {
    const Scenario before = m_document->scenario();
    set("rod.length", 12 * 0.3048);
    UnitChoice& units = m_document->units();
    units.chooseForField(*findParameter("rod.length"), *findUnit(Quantity::length, "ft"));
    QCOMPARE(changeWords(before, m_document->scenario(), units), QString("L 12 ft"));
    QCOMPARE(changeWords(before, before, units), QString());
    // A section as the file calls it, once for all of that name; of another form not every number.
    Document string;
    string.startFrom(findExample("t38_string")->text, "string");
    const Scenario usual = string.scenario();
    string.assign(*findParameter("string.coupling.diameter"), 0.039, 1);
    QCOMPARE(changeWords(usual, string.scenario(), units), QString("coupling ⌀39 mm"));
    QCOMPARE(changeWords(before, usual, units), QString("drill string"));
}

void TestRuns::lettersAreGivenAnew() {
    pin();
    set("bit_rock.gap", 1e-3);
    pin();
    m_runs->remove(0);
    set("bit_rock.gap", 2e-3);
    pin();
    QCOMPARE(m_runs->list()->front().letter(), QString("B"));
    QCOMPARE(m_runs->list()->back().letter(), QString("A"));
}

void TestRuns::theSameResultIsPinnedOnce() {
    pin();
    QVERIFY(pin().contains("A  first"));
    QCOMPARE(m_runs->list()->size(), 1u);
}

void TestRuns::thereIsAnEndToThem() {
    for (int i = 0; i < mostRuns; ++i) {
        set("bit_rock.gap", 1e-3 * (i + 1));
        QCOMPARE(pin(), QString());
    }
    set("bit_rock.gap", 0.5e-3);
    QVERIFY(pin().startsWith("There are 12 runs"));
    QCOMPARE(int(m_runs->list()->size()), mostRuns);
}

void TestRuns::withoutItsRunTheReferenceIsAnother() {
    QVERIFY(!m_runs->reference());
    pin();
    QCOMPARE(m_runs->reference()->number, 0);
    set("bit_rock.gap", 1e-3);
    pin();
    m_runs->remove(0);
    QCOMPARE(m_runs->reference()->number, 1);
    m_runs->setReference({});
    QVERIFY(!m_runs->reference());
    m_runs->setReference(7);  // there is none
    QVERIFY(!m_runs->reference());
}

void TestRuns::whatHasNoBlowIsSolved() {
    m_solver = std::make_unique<RunSolver>(*m_runs);
    pin();
    set("bit_rock.gamma", 0.3);
    pin();
    QTRY_VERIFY(m_runs->list()->front().isSolved() && m_runs->list()->back().isSolved());
    // The numbers of the core, solved here.
    for (const Run& run : *m_runs->list()) {
        const Blow blow = solveBlow(run.contents.scenario, {}, Detail::histories, {}, Stresses::wanted);
        QCOMPARE(run.blow->summary.cor, blow.summary.cor);
    }
}

void TestRuns::undoLeavesThemAlone() {
    pin();
    set("bit_rock.stiffness", 3e8);
    pin();
    const RunListPtr before = m_runs->list();
    m_document->undoStack().undo();
    m_document->undoStack().redo();
    QCOMPARE(m_runs->list(), before);
}

void TestRuns::keptRunsComeBackWithTheirFile() {
    m_solver = std::make_unique<RunSolver>(*m_runs);
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin("medium");
    set("bit_rock.stiffness", 3e8);
    pin();
    m_runs->rename(1, "hard, \"very\"");
    m_runs->setShown(1, false);
    m_runs->setReference(1);
    QTRY_VERIFY(m_runs->list()->back().isSolved());
    const RunList before = *m_runs->list();
    QCOMPARE(kept(), QString());

    Document reopened;
    Runs runs(reopened.units());
    RunSolver solver(runs);
    RunKeeper keeper(reopened, runs);
    QSignalSpy failures(&keeper, &RunKeeper::failed);
    QCOMPARE(reopened.open(path("t38.yaml")), QString());
    QCOMPARE(titles(runs), QStringList({"A  medium", "B  hard, \"very\""}));
    QVERIFY(keeper.isKept());
    QVERIFY(!runs.list()->back().isShown);
    QCOMPARE(runs.reference()->number, 1);
    QTRY_VERIFY(runs.list()->front().isSolved() && runs.list()->back().isSolved());
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE((*runs.list())[i].contents.text, before[i].contents.text);
        QCOMPARE((*runs.list())[i].contents.scenario, before[i].contents.scenario);
        QCOMPARE((*runs.list())[i].blow->summary.cor, before[i].blow->summary.cor);
    }
    QCOMPARE(failures.count(), 0);
}

void TestRuns::withoutRunsTheyAreKeptAsWell() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QCOMPARE(kept(), QString());
    m_runs->remove(0);
    QTRY_VERIFY(!QFile::exists(path("t38.runs/A.yaml")));
    QCOMPARE(m_document->open(path("t38.yaml")), QString());
    QVERIFY(m_keeper->isKept());
    QVERIFY(!m_keeper->holdsOthers());
    pin();
    QTRY_VERIFY(QFile::exists(path("t38.runs/A.yaml")));
}

void TestRuns::everyChangeIsWritten() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    QVERIFY(!m_keeper->holdsOthers());
    QCOMPARE(kept(), QString());
    pin();
    QTRY_VERIFY(QFile::exists(path("t38.runs/A.yaml")));
    QCOMPARE(read(path("t38.runs/A.yaml")), m_document->text());
    m_runs->rename(0, "other");
    QCOMPARE(m_keeper->finish(), QString());
    QVERIFY(read(path("t38.runs/runs.csv")).contains("A.yaml,other,yes,yes,"));
    m_runs->remove(0);
    QTRY_VERIFY(!QFile::exists(path("t38.runs/A.yaml")));
}

void TestRuns::onlyWhatChangesIsWritten() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    set("bit_rock.gap", 1e-3);
    pin();
    QCOMPARE(kept(), QString());
    // A file that takes its place has other permissions.
    QVERIFY(QFile::setPermissions(path("t38.runs/A.yaml"), QFile::ReadOwner | QFile::ReadUser));
    const QFile::Permissions mark = QFile::permissions(path("t38.runs/A.yaml"));
    QVERIFY(QFile::remove(path("t38.runs/B.yaml")));
    m_runs->rename(0, "other");
    QCOMPARE(m_keeper->finish(), QString());
    QVERIFY(read(path("t38.runs/runs.csv")).contains("A.yaml,other,"));
    QCOMPARE(QFile::permissions(path("t38.runs/A.yaml")), mark);
    QVERIFY(QFile::exists(path("t38.runs/B.yaml")));
}

void TestRuns::theDiskIsWaitedForBesideTheWindow() {
    SlowDisk disk;
    m_keeper = std::make_unique<RunKeeper>(*m_document, *m_runs, nullptr, disk.writer());
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QCOMPARE(m_keeper->keep(), QString());
    disk.waitUntilItIsBusy();
    // Here already, while nothing is there yet; of the changes meanwhile the last one is written.
    QVERIFY(m_keeper->isKept());
    QVERIFY(!QFile::exists(path("t38.runs")));
    for (const char* name : {"second", "third"}) {
        m_runs->rename(0, name);
        QCoreApplication::processEvents();
    }
    disk.goOn();
    QTRY_COMPARE(disk.writings(), 2);
    QCOMPARE(m_keeper->finish(), QString());
    QVERIFY(read(path("t38.runs/runs.csv")).contains("A.yaml,third,"));
    QVERIFY(!disk.isOfThisThread());
    QCOMPARE(disk.writings(), 2);
}

void TestRuns::whatCannotBeWrittenIsToldOnce() {
    const auto fails = [](RunsFolder&, const std::vector<NamedFile>&, ExistingFiles) {
        return Message{"%1: the disk is full", {"t38.runs"}};
    };
    m_keeper = std::make_unique<RunKeeper>(*m_document, *m_runs, nullptr, fails);
    QSignalSpy failures(m_keeper.get(), &RunKeeper::failed);
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    QCOMPARE(m_keeper->keep(), QString());
    QTRY_COMPARE(failures.count(), 1);
    QCOMPARE(failures[0][1].toString(), QString("t38.runs: the disk is full"));
    QVERIFY(!m_keeper->isKept());
    QCOMPARE(m_keeper->finish(), QString());
    // Reported to the caller who waits for it, and to nobody else.
    QCOMPARE(m_keeper->keep(), QString());
    QCOMPARE(m_keeper->finish(), QString("t38.runs: the disk is full"));
    QVERIFY(!m_keeper->isKept());
    QCoreApplication::processEvents();
    QCOMPARE(failures.count(), 1);
}

void TestRuns::whatIsLeftIsWrittenInTheEndAndNothingTold() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    QCOMPARE(kept(), QString());
    pin();
    m_keeper.reset();
    QCOMPARE(read(path("t38.runs/A.yaml")), m_document->text());
    auto keeper = std::make_unique<RunKeeper>(*m_document, *m_runs);
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    QVERIFY(keeper->isKept());
    write(path("t38.runs/A.yaml"), "mine");
    m_runs->rename(0, "other");
    QSignalSpy failures(keeper.get(), &RunKeeper::failed);
    QSignalSpy changes(keeper.get(), &RunKeeper::keptChanged);
    keeper.reset();
    QCOMPARE(failures.count(), 0);
    QCOMPARE(changes.count(), 0);
    QCOMPARE(read(path("t38.runs/A.yaml")), QByteArray("mine"));
}

void TestRuns::keptRunsGoAlongToANewName() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QCOMPARE(kept(), QString());
    QCOMPARE(m_document->save(path("t51.yaml")), QString());
    QCOMPARE(m_keeper->finish(), QString());
    QCOMPARE(read(path("t51.runs/A.yaml")), read(path("t38.runs/A.yaml")));
    QVERIFY(m_keeper->isKept());
}

void TestRuns::runsOfTheFileThatIsSavedOverAreAskedAbout() {
    QCOMPARE(m_document->save(path("t51.yaml")), QString());
    pin("mine");
    QCOMPARE(kept(), QString());
    const QByteArray theirs = read(path("t51.runs/A.yaml"));
    m_document->startFrom(findExample("t51_soft_rock")->text, "example");
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin("soft");
    QCOMPARE(kept(), QString());
    QSignalSpy questions(m_keeper.get(), &RunKeeper::othersFound);
    QCOMPARE(m_document->save(path("t51.yaml")), QString());
    QCOMPARE(questions.count(), 1);
    QVERIFY(!m_keeper->isKept());
    QVERIFY(m_keeper->holdsOthers());
    m_runs->rename(0, "renamed");
    QCoreApplication::processEvents();
    QCOMPARE(read(path("t51.runs/A.yaml")), theirs);
    QVERIFY(read(path("t51.runs/runs.csv")).contains("mine"));
}

void TestRuns::othersStayWhenAnotherFileIsOpened() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QCOMPARE(kept(), QString());
    m_document->startFrom(findExample("t51_soft_rock")->text, "example");
    QVERIFY(m_runs->list()->empty());  // they are in their folder
    pin("soft");
    m_document->startFrom(findExample("r32_hard_rock")->text, "example");
    QCOMPARE(titles(*m_runs), QStringList("A  soft"));  // it is nowhere else
    QCOMPARE(m_document->open(path("t38.yaml")), QString());
    QCOMPARE(titles(*m_runs), QStringList({"A  soft", "B  first"}));
}

void TestRuns::aBrokenRunIsToldAndNotWrittenOver() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    set("bit_rock.gap", 1e-3);
    pin();
    QCOMPARE(kept(), QString());
    write(path("t38.runs/A.yaml"), "drillwave: 1\nnonsense");
    QSignalSpy failures(m_keeper.get(), &RunKeeper::failed);
    QCOMPARE(m_document->open(path("t38.yaml")), QString());
    QCOMPARE(failures.count(), 1);
    QVERIFY(failures[0][1].toString().contains("t38.runs/A.yaml:"));
    QCOMPARE(m_runs->list()->size(), 1u);
    QVERIFY(!m_keeper->isKept());
    QVERIFY(m_keeper->holdsOthers());
    // A new run takes another letter.
    pin();
    QCOMPARE(m_runs->list()->back().letter(), QString("C"));
    QCOMPARE(kept(), QString());
    QCOMPARE(read(path("t38.runs/A.yaml")), QByteArray("drillwave: 1\nnonsense"));
}

void TestRuns::whatOthersPutIntoTheFolderIsNotWrittenOver() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QCOMPARE(kept(), QString());
    // Changed, new under a letter that is given next, and changed before it is removed.
    const auto isLeft = [this](const char* name, const std::function<void()>& change) {
        write(path(name), "mine");
        QSignalSpy failures(m_keeper.get(), &RunKeeper::failed);
        change();
        QTRY_COMPARE(failures.count(), 1);
        QVERIFY(failures[0][1].toString().startsWith(path(name) + ": "));
        QCOMPARE(read(path(name)), QByteArray("mine"));
        QVERIFY(!m_keeper->isKept());
        QVERIFY(m_keeper->holdsOthers());
        QVERIFY(!kept().isEmpty());
        QCOMPARE(kept(ExistingFiles::replaced), QString());
        QVERIFY(m_keeper->isKept());
        QVERIFY(!QFile::exists(path(name)) || read(path(name)) != "mine");
    };
    isLeft("t38.runs/runs.csv", [this] { m_runs->rename(0, "other"); });
    isLeft("t38.runs/B.yaml", [this] {
        set("bit_rock.gap", 1e-3);
        pin();
    });
    isLeft("t38.runs/A.yaml", [this] { m_runs->remove(0); });
    write(path("t38.runs/B.yaml"), "mine");
    m_keeper->giveUp();
    QCOMPARE(QDir(path("t38.runs")).entryList(QDir::Files), QStringList("B.yaml"));
}

void TestRuns::lettersOfOtherFilesAreNotGiven() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QCOMPARE(kept(), QString());
    write(path("t38.runs/B.yaml"), "mine");
    m_document->startFrom(findExample("t51_soft_rock")->text, "example");
    pin("soft");
    QCOMPARE(m_document->open(path("t38.yaml")), QString());
    QCOMPARE(titles(*m_runs), QStringList({"A  soft", "C  first"}));
    QVERIFY(m_keeper->isKept());
    // The file of a run on the list would be written over.
    m_document->startFrom(findExample("t51_soft_rock")->text, "example");
    pin("soft");
    set("bit_rock.gap", 1e-3);
    pin("gap");
    QCOMPARE(m_runs->list()->back().letter(), QString("B"));
    QSignalSpy failures(m_keeper.get(), &RunKeeper::failed);
    QCOMPARE(m_document->open(path("t38.yaml")), QString());
    QCOMPARE(failures.count(), 1);
    QVERIFY(failures[0][1].toString().startsWith("B  "));
    QVERIFY(!m_keeper->isKept());
}

void TestRuns::aChangedTableIsTold() {
    write(path("blow.csv"), "time [us],force [kN]\n0,0\n100,300\n200,0\n");
    m_solver = std::make_unique<RunSolver>(*m_runs);
    QCOMPARE(m_document->useTable(path("blow.csv")), QString());
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QTRY_VERIFY(m_runs->list()->front().isSolved());
    QCOMPARE(kept(), QString());
    const QByteArray index = read(path("t38.runs/runs.csv"));
    write(path("blow.csv"), "time [us],force [kN]\n0,0\n100,900\n900,0\n");
    QSignalSpy failures(m_keeper.get(), &RunKeeper::failed);
    QCOMPARE(m_document->open(path("t38.yaml")), QString());
    QTRY_COMPARE(failures.count(), 1);
    QVERIFY(failures[0][1].toString().startsWith("A  first had e = "));
    // And again the next time.
    QCoreApplication::processEvents();
    QCOMPARE(read(path("t38.runs/runs.csv")), index);
    QCOMPARE(m_document->open(path("t38.yaml")), QString());
    QTRY_COMPARE(failures.count(), 2);
}

void TestRuns::tablesAreFoundFromAnotherFolder() {
    write(path("blow.csv"), "time [us],force [kN]\n0,0\n100,300\n200,0\n");
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    QCOMPARE(m_document->useTable(path("blow.csv")), QString());
    QCOMPARE(m_document->scenario().pulse.tableFile, std::string("blow.csv"));
    pin();
    QCOMPARE(kept(), QString());
    set("bit_rock.gap", 1e-3);
    QVERIFY(QDir().mkdir(path("elsewhere")));
    QCOMPARE(m_document->save(path("elsewhere/t38.yaml")), QString());
    QCOMPARE(m_document->useContents(m_runs->list()->front().contents, "revert"), QString());
    QCOMPARE(m_document->tablePath(), path("blow.csv"));
    QSignalSpy failures(m_keeper.get(), &RunKeeper::failed);
    QCOMPARE(m_document->open(path("elsewhere/t38.yaml")), QString());
    QCOMPARE(failures.count(), 0);
    QCOMPARE(m_runs->list()->size(), 1u);
    QCOMPARE(m_runs->list()->front().contents.scenario.pulse.tableFile, std::string("../blow.csv"));
}

void TestRuns::givenUpNothingIsLeft() {
    QVERIFY(!kept().isEmpty());  // beside no file
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    pin();
    QCOMPARE(kept(), QString());
    write(path("t38.runs/notes.txt"), "mine");
    m_keeper->giveUp();
    QCOMPARE(QDir(path("t38.runs")).entryList(QDir::Files), QStringList("notes.txt"));
    QFile::remove(path("t38.runs/notes.txt"));
    QCOMPARE(kept(), QString());
    m_keeper->giveUp();
    QVERIFY(!QFile::exists(path("t38.runs")));
    QVERIFY(!m_keeper->isKept());
    QCOMPARE(m_runs->list()->size(), 1u);
}

// Comments behind values are dropped with them and come back with the bytes, also after saving.
void TestRuns::revertingBringsTheBytesBack() {
    const QByteArray text =
        "# mine\n" + m_document->text().replace("gamma: 0.1", "gamma:   0.1   # by experience");
    m_document->startFrom(text.toStdString(), "mine");
    QCOMPARE(m_document->text(), text);
    pin();
    set("bit_rock.gamma", 0.3);
    QVERIFY(!m_document->text().contains("by experience"));
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    const QByteArray changed = m_document->text();
    const int steps = m_document->undoStack().count();
    QCOMPARE(m_document->useContents(m_runs->list()->front().contents, "revert to A"), QString());
    QCOMPARE(m_document->text(), text);
    QCOMPARE(m_document->undoStack().count(), steps + 1);
    QCOMPARE(m_document->undoStack().undoText(), QString("revert to A"));
    m_document->undoStack().undo();
    QCOMPARE(m_document->text(), changed);
    QVERIFY(!m_document->isModified());
    m_document->undoStack().redo();
    QCOMPARE(m_document->text(), text);
    QCOMPARE(m_document->useContents(m_runs->list()->front().contents, "again"), QString());
    QCOMPARE(m_document->undoStack().count(), steps + 1);  // nothing to be undone
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    QCOMPARE(read(path("t38.yaml")), text);
}

// Saving writes a file and leaves every step of the history its bytes.
void TestRuns::savingLeavesEveryStepItsBytes() {
    const QByteArray text =
        "# mine\n" + m_document->text().replace("gamma: 0.1", "gamma:   0.1   # by experience");
    m_document->startFrom(text.toStdString(), "mine");
    pin();
    set("bit_rock.gamma", 0.3);
    QCOMPARE(m_document->useContents(m_runs->list()->front().contents, "revert to A"), QString());
    set("bit_rock.gamma", 0.5);
    QUndoStack& history = m_document->undoStack();
    QCOMPARE(history.count(), 3);
    QList<QByteArray> steps;
    for (int step = 0; step <= 3; ++step) {
        history.setIndex(step);
        steps << m_document->text();
    }
    QCOMPARE(steps[2], text);
    QVERIFY(!steps[1].contains("by experience") && !steps[3].contains("by experience"));
    for (const int savedAt : {3, 2, 0, 1}) {
        history.setIndex(savedAt);
        QCOMPARE(m_document->save(path("t38.yaml")), QString());
        for (const int step : {0, 1, 2, 3, 2, 1, 2, 3, 0}) {
            history.setIndex(step);
            QCOMPARE(m_document->text(), steps[step]);
            // An unmodified document is what the file says.
            QCOMPARE(!m_document->isModified(), step == savedAt);
            if (step == savedAt) QCOMPARE(read(path("t38.yaml")), steps[step]);
        }
    }
}

// Also for a file in which only a comment has changed.
void TestRuns::reloadingIsAStepWithItsBytes() {
    QCOMPARE(m_document->save(path("t38.yaml")), QString());
    const QByteArray before = m_document->text(), after = before + "# a note\n";
    QCOMPARE(m_document->reload(), QString());
    QCOMPARE(m_document->undoStack().count(), 0);  // nothing new
    write(path("t38.yaml"), after);
    QCOMPARE(m_document->reload(), QString());
    QVERIFY(!m_document->isModified());
    QCOMPARE(m_document->text(), after);
    m_document->undoStack().undo();
    QCOMPARE(m_document->text(), before);
    QVERIFY(m_document->isModified());
    m_document->undoStack().redo();
    QCOMPARE(m_document->text(), after);
    QVERIFY(!m_document->isModified());
}

void TestRuns::everyRunHasAColourAndADashOfItsOwn() {
    for (const QColor background : {QColor(Qt::white), QColor(0x1e, 0x1e, 0x1e)}) {
        PlotStyle style = PlotStyle::forPaper();
        style.background = background;
        for (int i = 0; i < mostRuns; ++i) {
            const QPen pen = runPen(i, style);
            QVERIFY(!pen.isSolid() || pen.style() != Qt::SolidLine);
            QVERIFY2(test::contrast(pen.color(), background) >= test::leastContrast,
                     qPrintable(QString::number(i)));
            for (int j = 0; j < i; ++j) {
                const QPen other = runPen(j, style);
                const bool isOtherColour = pen.color() != other.color();
                const bool isOtherDash = pen.dashPattern() != other.dashPattern();
                QVERIFY(isOtherColour || isOtherDash);
                if (i < 6) QVERIFY(isOtherColour && isOtherDash);
            }
        }
    }
}

void TestRuns::differencesAreReadable() {
    QCOMPARE(relativeText(0.634, 0.4297), QString("+47.5 %").replace(' ', QChar::Nbsp));
    QCOMPARE(relativeText(-1, 1), QString("−200 %").replace(' ', QChar::Nbsp));
    QCOMPARE(relativeText(1, -2), QString("+150 %").replace(' ', QChar::Nbsp));
    QCOMPARE(relativeText(2, 2), QString("±0 %").replace(' ', QChar::Nbsp));
    QCOMPARE(relativeText(2.0001, 2), QString("≈0 %").replace(' ', QChar::Nbsp));
    QCOMPARE(relativeText(30, 2), QString("×15"));
    QCOMPARE(relativeText(30, 0), QString());
    // There is no factor between numbers of different signs.
    QCOMPARE(relativeText(60, -3), QString("+2100 %").replace(' ', QChar::Nbsp));
    QCOMPARE(relativeText(-60, 3), QString("−2100 %").replace(' ', QChar::Nbsp));
    QCOMPARE(signedText(-0.25), QString("−0.25"));
    QCOMPARE(signedText(0.25), QString("+0.25"));
}

QTEST_MAIN(TestRuns)
#include "tst_runs.moc"
