// SPDX-License-Identifier: GPL-3.0-or-later
// Files put into a folder together: all of them or none, and nothing of anybody else is touched.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cerrno>
#include <system_error>
#include <thread>

#include "core/disk/hidden_folder.h"
#include "core/disk/whole_file.h"
#include "core/disk/whole_folder.h"
#include "tests/support/files.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// As the system says it, in the language of the user.
std::string reason(int error) {
    return std::generic_category().message(error);
}

/// Everything in a folder, hidden things too.
QStringList contents(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

FolderFiles set(const std::string& mark) {
    return {.files = {{"a", "a " + mark}, {"b", "b " + mark}, {"last", "last " + mark}}, .outdated = {}};
}

}  // namespace

class TestWholeFolder : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_place = std::make_unique<QTemporaryDir>(); }
    void aNewFolderAppearsWithItsParents();
    void foreignFilesStay();
    void existingFilesAreKeptUnlessAskedFor();
    void aFailureHalfWayBringsBackWhatWasThere();
    void aStopLeavesNothing();
    void outdatedFilesGo();
    void outdatedFilesAreInTheWayOfTheCareful();
    void aFileOnItsWayComesLast();
    void aFolderInPlaceOfAFileIsNotRemoved();
    void aLinkToAFolderIsFollowed();
    void obstaclesAreKnownBefore();
    void writersAtTheSameTimeNeverMix();
    void locksThatCannotBeOpenedAreNamed();
    void linksInPlaceOfLocksAreNotFollowed();
    void waitingForALockIsToldAndCanBeStopped();

  private:
    QString path(const char* name) const { return m_place->filePath(QLatin1String(name)); }
    std::string plain(const char* name) const { return path(name).toStdString(); }
    std::unique_ptr<QTemporaryDir> m_place;
};

void TestWholeFolder::aNewFolderAppearsWithItsParents() {
    const FolderEnd end = writeWholeFolder(plain("x/y/z/"), set("1"), ExistingFiles::kept);
    QVERIFY2(end.isWritten(), end.problem.text().c_str());
    QCOMPARE(contents(path("x/y/z")), QStringList({"a", "b", "last"}));
    QCOMPARE(contents(path("x/y")), QStringList{"z"});
    QCOMPARE(read(path("x/y/z/b")), QByteArray("b 1"));
    // As mkdir would have made it.
    QVERIFY(QDir(m_place->path()).mkdir("plain"));
    QCOMPARE(QFileInfo(path("x/y/z")).permissions(), QFileInfo(path("plain")).permissions());
}

void TestWholeFolder::foreignFilesStay() {
    QVERIFY(QDir(m_place->path()).mkpath("f/sub"));
    write(path("f/notes"), "mine");
    write(path("f/sub/deep"), "mine too");
    for (const char* mark : {"1", "2"}) {
        QVERIFY(writeWholeFolder(plain("f"), set(mark), ExistingFiles::replaced).isWritten());
        QCOMPARE(contents(path("f")), QStringList({"a", "b", "last", "notes", "sub"}));
        QCOMPARE(read(path("f/a")), QByteArray("a ") + mark);
    }
    QCOMPARE(read(path("f/notes")), QByteArray("mine"));
    QCOMPARE(read(path("f/sub/deep")), QByteArray("mine too"));
}

void TestWholeFolder::existingFilesAreKeptUnlessAskedFor() {
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    write(path("f/b"), "mine");
    const FolderEnd end = writeWholeFolder(plain("f"), set("1"), ExistingFiles::kept);
    QCOMPARE(end.kind, FolderEnd::Kind::failed);
    QVERIFY2(end.problem.text().starts_with(plain("f/b: exists already")), end.problem.text().c_str());
    QCOMPARE(contents(path("f")), QStringList{"b"});
    QCOMPARE(read(path("f/b")), QByteArray("mine"));
}

void TestWholeFolder::aFailureHalfWayBringsBackWhatWasThere() {
    QVERIFY(writeWholeFolder(plain("f"), set("old"), ExistingFiles::kept).isWritten());
    FolderFiles files = set("new");
    // Called when all is checked and nothing moved: takes away one of the files that are to be moved.
    bool removed = false;
    files.outdated = [&](const std::string& name) {
        const QDir folder(QString::fromStdString(name));
        for (const QString& hidden : folder.entryList({".drillwave-*"}, QDir::Dirs | QDir::Hidden))
            removed = QFile::remove(folder.filePath(hidden + "/new/b"));
        return std::vector<std::string>();
    };
    const FolderEnd end = writeWholeFolder(plain("f"), files, ExistingFiles::replaced);
    QVERIFY(removed);
    QCOMPARE(end.kind, FolderEnd::Kind::failed);
    QVERIFY2(end.problem.text().starts_with(plain("f/b: cannot be written: ") + reason(ENOENT)),
             end.problem.text().c_str());
    QCOMPARE(contents(path("f")), QStringList({"a", "b", "last"}));
    for (const char* name : {"a", "b", "last"}) QCOMPARE(read(path("f/") + name), QByteArray(name) + " old");
}

void TestWholeFolder::aStopLeavesNothing() {
    std::stop_source stop;
    stop.request_stop();
    for (const char* folder : {"x/y", "f"}) {
        if (*folder == 'f') QVERIFY(QDir(m_place->path()).mkdir("f"));
        const FolderEnd end =
            writeWholeFolder(plain(folder), set("1"), ExistingFiles::kept, stop.get_token());
        QCOMPARE(end.kind, FolderEnd::Kind::stopped);
    }
    QCOMPARE(contents(m_place->path()), QStringList{"f"});
    QCOMPARE(contents(path("f")), QStringList());
}

void TestWholeFolder::outdatedFilesGo() {
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    for (const char* name : {"a", "picture", "notes"}) write(path("f/") + name, "before");
    FolderFiles files = set("1");
    files.outdated = [](const std::string&) { return std::vector<std::string>{"picture", "a", "gone"}; };
    QVERIFY(writeWholeFolder(plain("f"), files, ExistingFiles::replaced).isWritten());
    QCOMPARE(contents(path("f")), QStringList({"a", "b", "last", "notes"}));
}

void TestWholeFolder::outdatedFilesAreInTheWayOfTheCareful() {
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    write(path("f/picture"), "before");
    FolderFiles files = set("1");
    files.outdated = [](const std::string&) { return std::vector<std::string>{"picture"}; };
    const FolderEnd end = writeWholeFolder(plain("f"), files, ExistingFiles::kept);
    QVERIFY2(end.problem.text().starts_with(plain("f/picture: exists already")), end.problem.text().c_str());
    QCOMPARE(contents(path("f")), QStringList{"picture"});
}

void TestWholeFolder::aFileOnItsWayComesLast() {
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    for (const char* mark : {"1", "2"}) {
        WholeFile rows(plain("f/rows"));
        QVERIFY(!rows.open());
        for (const char* part : {"rows ", mark}) QVERIFY(!rows.write(part));
        FolderFiles files = set(mark);
        files.last = &rows;
        QCOMPARE(files.names().back(), std::string("rows"));
        QVERIFY(writeWholeFolder(plain("f"), files, ExistingFiles::replaced).isWritten());
        QCOMPARE(contents(path("f")), QStringList({"a", "b", "last", "rows"}));
        QCOMPARE(read(path("f/rows")), QByteArray("rows ") + mark);
    }
    WholeFile late(plain("f/rows"));
    QVERIFY(!late.open());
    FolderFiles files;
    files.last = &late;
    QVERIFY(!writeWholeFolder(plain("f"), files, ExistingFiles::kept).isWritten());
    QCOMPARE(read(path("f/rows")), QByteArray("rows 2"));
    QCOMPARE(contents(path("f")), QStringList({"a", "b", "last", "rows"}));
}

void TestWholeFolder::aFolderInPlaceOfAFileIsNotRemoved() {
    QVERIFY(QDir(m_place->path()).mkpath("f/last/precious"));
    QVERIFY(QDir(m_place->path()).mkpath("g/picture/precious"));
    FolderFiles files = set("1");
    files.outdated = [](const std::string&) { return std::vector<std::string>{"picture"}; };
    for (const char* folder : {"f", "g"}) {
        const FolderEnd end = writeWholeFolder(plain(folder), files, ExistingFiles::replaced);
        QVERIFY2(end.problem.text().find("is there and no file") != std::string::npos,
                 end.problem.text().c_str());
        QCOMPARE(contents(path(folder)).size(), 1);
    }
    QVERIFY(QFileInfo::exists(path("f/last/precious")));
    QVERIFY(QFileInfo::exists(path("g/picture/precious")));
}

void TestWholeFolder::aLinkToAFolderIsFollowed() {
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    QVERIFY(QFile::link(path("f"), path("link")));
    QVERIFY(writeWholeFolder(plain("link"), set("1"), ExistingFiles::kept).isWritten());
    QVERIFY(QFileInfo(path("link")).isSymLink());
    QCOMPARE(contents(path("f")), QStringList({"a", "b", "last"}));
}

void TestWholeFolder::obstaclesAreKnownBefore() {
    write(path("file"), "mine");
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    write(path("f/b"), "mine");
    for (const char* folder : {"file", "file/x/y"}) {
        const std::string before = folderProblem(plain(folder), {"a"}, ExistingFiles::replaced).text();
        QVERIFY2(before.find("cannot be made: " + reason(ENOTDIR)) != std::string::npos, before.c_str());
        QCOMPARE(writeWholeFolder(plain(folder), set("1"), ExistingFiles::replaced).kind,
                 FolderEnd::Kind::failed);
    }
    QVERIFY(!folderProblem(plain("f"), {"a", "b"}, ExistingFiles::kept).isEmpty());
    QVERIFY(folderProblem(plain("f"), {"a", "b"}, ExistingFiles::replaced).isEmpty());
    QVERIFY(folderProblem(plain("new/one"), {"a"}, ExistingFiles::kept).isEmpty());
    QCOMPARE(contents(m_place->path()), QStringList({"f", "file"}));
}

// Which of them wins is left to chance, but not that it wins whole.
void TestWholeFolder::writersAtTheSameTimeNeverMix() {
    constexpr int rounds = 20;
    constexpr int writers = 6;
    for (const ExistingFiles existing : {ExistingFiles::kept, ExistingFiles::replaced})
        for (int round = 0; round < rounds; ++round) {
            const QString folder = path("f") + QString::number(round);
            std::atomic<int> written = 0;
            {
                std::vector<std::jthread> threads;
                for (int i = 0; i < writers; ++i)
                    threads.emplace_back([&, i] {
                        written += writeWholeFolder(folder.toStdString(), set(std::to_string(i)), existing)
                                       .isWritten();
                    });
            }
            QCOMPARE(contents(folder), QStringList({"a", "b", "last"}));
            const QByteArray mark = read(folder + "/a").mid(1);
            QCOMPARE(read(folder + "/b"), "b" + mark);
            QCOMPARE(read(folder + "/last"), "last" + mark);
            QCOMPARE(written.load(), existing == ExistingFiles::kept ? 1 : writers);
            QVERIFY(QDir(folder).removeRecursively());
        }
}

void TestWholeFolder::locksThatCannotBeOpenedAreNamed() {
    QVERIFY(QDir(m_place->path()).mkpath("f/.drillwave.lock"));
    const std::string told =
        plain("f/.drillwave.lock: this lock of the folder cannot be opened: ") + reason(EISDIR);
    const std::string before = folderProblem(plain("f"), {"a"}, ExistingFiles::kept).text();
    QVERIFY2(before.starts_with(told), before.c_str());
    const FolderEnd end = writeWholeFolder(plain("f"), set("1"), ExistingFiles::kept);
    QVERIFY2(end.problem.text().starts_with(told), end.problem.text().c_str());
    QCOMPARE(contents(path("f")), QStringList{".drillwave.lock"});
}

void TestWholeFolder::linksInPlaceOfLocksAreNotFollowed() {
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    QVERIFY(QFile::link(path("target"), path("f/.drillwave.lock")));
    const FolderEnd end = writeWholeFolder(plain("f"), set("1"), ExistingFiles::kept);
    QVERIFY2(end.problem.text().find("cannot be opened: it is a link") != std::string::npos,
             end.problem.text().c_str());
    QVERIFY(!QFileInfo::exists(path("target")));
}

void TestWholeFolder::waitingForALockIsToldAndCanBeStopped() {
    QVERIFY(QDir(m_place->path()).mkdir("f"));
    FolderLock held(plain("f"));
    QCOMPARE(held.tryLock(), 0);
    std::vector<std::string> told;
    std::stop_source stop;
    const FolderEnd end = writeWholeFolder(plain("f"), set("1"), ExistingFiles::kept, stop.get_token(),
                                           [&](const std::string& lock) {
                                               told.push_back(lock);
                                               stop.request_stop();
                                           });
    QCOMPARE(end.kind, FolderEnd::Kind::stopped);
    QCOMPARE(told, std::vector{plain("f/.drillwave.lock")});
    QCOMPARE(contents(path("f")), QStringList{".drillwave.lock"});
}

QTEST_GUILESS_MAIN(TestWholeFolder)
#include "tst_whole_folder.moc"
