// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that die while files change places, at every moment of it: the next one finds one whole set or the
// other.
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <functional>
#include <thread>

#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/disk/hidden_folder.h"
#include "core/disk/whole_folder.h"
#include "tests/support/files.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// The errno of every lock; 0 for locks as the system has them.
int lockError = 0;

const std::vector<std::string> names{"picture", "record", "rows"};

QStringList contents(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

/// A process that does this and is killed as nothing can be caught.
void die(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    QVERIFY(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

void move(const std::string& from, const std::string& to) {
    if (std::rename(from.c_str(), to.c_str()) != 0) qFatal("%s does not move", from.c_str());
}

}  // namespace

/// Stands before that of the C library: a disk without locks (Lustre, NFS).
extern "C" int flock(int descriptor, int operation) noexcept {
    if (lockError == 0) return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
    errno = lockError;
    return -1;
}

class TestHiddenFolder : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_place = std::make_unique<QTemporaryDir>(); }
    void whatADeadRunLeftIsMended_data();
    void whatADeadRunLeftIsMended();
    void theNextWriterMendsFirst();
    void aRunThatDiesBeforeItBeginsLeavesNothing();
    void whatDiesBetweenItsStepsGoesToo();
    void aRunThatDiesOnceItHasMadeTheFolderLeavesNothing();
    void aLivingRunIsLeftAlone();
    void makersAndMendersDoNotMeet();
    void disksWithoutLocksKeepNothingBehind_data();
    void disksWithoutLocksKeepNothingBehind();

  private:
    std::string path(const std::string& name) const { return m_place->path().toStdString() + "/" + name; }
    QByteArray bytes(const std::string& name) const { return read(QString::fromStdString(path(name))); }
    /// Exchanges as writeWholeFolder() does and dies after so many files.
    void dieAfter(int moves) const;
    std::unique_ptr<QTemporaryDir> m_place;
};

void TestHiddenFolder::dieAfter(int moves) const {
    const std::string folder = m_place->path().toStdString();
    die([&] {
        FolderLock lock(folder);
        HiddenFolder hidden;
        if (lock.tryLock() != 0 || hidden.make(folder) != 0) std::_Exit(1);
        for (const std::string& name : names) replaceFile(hidden.newFile(name), "new " + name);
        if (hidden.beginExchange(names)) std::_Exit(1);
        int done = 0;
        for (auto name = names.rbegin(); name != names.rend() && done < moves; ++name, ++done)
            move(path(*name), hidden.oldFile(*name));
        for (auto name = names.begin(); name != names.end() && done < moves; ++name, ++done)
            move(hidden.newFile(*name), path(*name));
        ::kill(::getpid(), SIGKILL);
    });
}

void TestHiddenFolder::whatADeadRunLeftIsMended_data() {
    QTest::addColumn<int>("moves");
    for (int moves = 0; moves <= 6; ++moves) QTest::addRow("after %d of 6 files", moves) << moves;
}

void TestHiddenFolder::whatADeadRunLeftIsMended() {
    QFETCH(int, moves);
    for (const std::string& name : names) QVERIFY(!replaceFile(path(name), "old " + name));
    QVERIFY(!replaceFile(path("notes"), "mine"));
    dieAfter(moves);
    // Never files of both: what is to go is gone before the first one comes.
    QSet<QByteArray> marks;
    for (const std::string& name : names)
        if (isThere(path(name))) marks << bytes(name).left(3);
    QVERIFY(marks.size() <= 1);
    mendFolder(m_place->path().toStdString());
    QCOMPARE(contents(m_place->path()), QStringList({"notes", "picture", "record", "rows"}));
    const QByteArray mark = moves == 6 ? "new " : "old ";
    for (const std::string& name : names) QCOMPARE(bytes(name), mark + name.c_str());
    QCOMPARE(bytes("notes"), QByteArray("mine"));
}

void TestHiddenFolder::theNextWriterMendsFirst() {
    for (const std::string& name : names) QVERIFY(!replaceFile(path(name), "old " + name));
    dieAfter(4);
    QVERIFY(!isThere(path("rows")));
    const FolderFiles other{.files = {{"other", "other"}}, .outdated = {}};
    QVERIFY(writeWholeFolder(m_place->path().toStdString(), other, ExistingFiles::kept).isWritten());
    QCOMPARE(contents(m_place->path()), QStringList({"other", "picture", "record", "rows"}));
    for (const std::string& name : names) QCOMPARE(bytes(name), QByteArray("old ") + name.c_str());
}

void TestHiddenFolder::aRunThatDiesBeforeItBeginsLeavesNothing() {
    const std::string folder = m_place->path().toStdString();
    QVERIFY(!replaceFile(path("rows"), "old"));
    die([&] {
        HiddenFolder hidden;
        if (hidden.make(folder) != 0) std::_Exit(1);
        replaceFile(hidden.newFile("rows"), "new");
        ::kill(::getpid(), SIGKILL);
    });
    QCOMPARE(contents(m_place->path()).size(), 2);
    mendFolder(folder);
    QCOMPARE(contents(m_place->path()), QStringList{"rows"});
    QCOMPARE(bytes("rows"), QByteArray("old"));
}

// A folder is made by giving the hidden one its name, with what else was hidden left around it.
void TestHiddenFolder::aRunThatDiesOnceItHasMadeTheFolderLeavesNothing() {
    const std::string around = m_place->path().toStdString(), folder = path("results");
    die([&] {
        HiddenFolder hidden;
        if (hidden.make(around) != 0) std::_Exit(1);
        replaceFile(hidden.newFile("rows"), "first");
        std::rename(hidden.newFolder().c_str(), folder.c_str());
        ::kill(::getpid(), SIGKILL);
    });
    QCOMPARE(contents(m_place->path()).size(), 2);
    const FolderFiles next{.files = {{"rows", "next"}}, .outdated = {}};
    QVERIFY(writeWholeFolder(folder, next, ExistingFiles::replaced).isWritten());
    QCOMPARE(contents(m_place->path()), QStringList{"results"});
    QCOMPARE(bytes("results/rows"), QByteArray("next"));
}

void TestHiddenFolder::aLivingRunIsLeftAlone() {
    HiddenFolder hidden;
    QCOMPARE(hidden.make(m_place->path().toStdString()), 0);
    QVERIFY(!replaceFile(hidden.newFile("rows"), "new"));
    mendFolder(m_place->path().toStdString());
    QCOMPARE(read(QString::fromStdString(hidden.newFile("rows"))), QByteArray("new"));
}

void TestHiddenFolder::whatDiesBetweenItsStepsGoesToo() {
    const std::string folder = m_place->path().toStdString();
    // Made and not yet locked; locked without the parts; the lock of a run that had repaired all.
    for (const char* made : {".drillwave-aaaaaa", ".drillwave-bbbbbb"})
        QVERIFY(QDir(m_place->path()).mkdir(made));
    QVERIFY(!replaceFile(path(".drillwave-bbbbbb/.drillwave.lock"), ""));
    QVERIFY(!replaceFile(path(".drillwave.lock"), ""));
    mendFolder(folder);
    QCOMPARE(contents(m_place->path()), QStringList());
    QVERIFY(!replaceFile(path(".drillwave.lock"), ""));
    mendFolder(folder);
    QCOMPARE(contents(m_place->path()), QStringList());
}

// A mending run may find a folder that is made and not yet locked, and take it for that of a dead one.
void TestHiddenFolder::makersAndMendersDoNotMeet() {
    const std::string folder = m_place->path().toStdString();
    std::atomic<int> wrong = 0, made = 0;
    std::atomic<bool> done = false;
    std::vector<std::jthread> threads;
    for (int maker = 0; maker < 2; ++maker)
        threads.emplace_back([&] {
            for (int i = 0; i < 500; ++i) {
                HiddenFolder hidden;
                if (hidden.make(folder) != 0 || replaceFile(hidden.newFile("rows"), "new") ||
                    replaceFile(hidden.oldFile("rows"), "old"))
                    ++wrong;
                ++made;
            }
        });
    std::jthread mender([&] {
        while (!done) mendFolder(folder);
    });
    threads.clear();
    done = true;
    mender.join();
    QCOMPARE(made.load(), 1000);
    QCOMPARE(wrong.load(), 0);
    mendFolder(folder);
    QCOMPARE(contents(m_place->path()), QStringList());
}

void TestHiddenFolder::disksWithoutLocksKeepNothingBehind_data() {
    QTest::addColumn<int>("error");
    QTest::newRow("Lustre as mounted by default") << ENOSYS;
    QTest::newRow("NFS without a lock service") << ENOLCK;
    QTest::newRow("not supported") << EOPNOTSUPP;
}

void TestHiddenFolder::disksWithoutLocksKeepNothingBehind() {
    QFETCH(int, error);
    const std::string folder = m_place->path().toStdString();
    const FolderFiles files{.files = {{"rows", "new"}}, .outdated = {}};
    lockError = error;
    const FolderEnd first = writeWholeFolder(folder, files, ExistingFiles::kept);
    const FolderEnd second = writeWholeFolder(folder, files, ExistingFiles::replaced);
    mendFolder(folder);
    lockError = 0;
    QVERIFY2(first.isWritten() && second.isWritten(), second.problem.text().c_str());
    QCOMPARE(contents(m_place->path()), QStringList{"rows"});
}

QTEST_GUILESS_MAIN(TestHiddenFolder)
#include "tst_hidden_folder.moc"
