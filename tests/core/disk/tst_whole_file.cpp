// SPDX-License-Identifier: GPL-3.0-or-later
// A file written whole or not at all: it is the old or the new one, and nothing lies about.
#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <memory>

#include "core/disk/whole_file.h"

using namespace drillwave;

namespace {

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(not there)");
}

void put(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("cannot write");
}

}  // namespace

class TestWholeFile : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_place = std::make_unique<QTemporaryDir>(); }
    void aNewFileIsAsAnyProgramMakesIt();
    void permissionsStay();
    void aLinkStaysALinkToTheFile();
    void nothingIsSeenBeforeItIsCommitted();
    void aFailureLeavesTheFileAsItWas();
    void obstaclesAreNamed();

  private:
    QString path(const char* name) const { return m_place->filePath(QLatin1String(name)); }
    std::string plain(const char* name) const { return path(name).toStdString(); }
    /// Everything there, hidden things too.
    QStringList contents() const {
        return QDir(m_place->path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot, QDir::Name);
    }
    std::unique_ptr<QTemporaryDir> m_place;
};

void TestWholeFile::aNewFileIsAsAnyProgramMakesIt() {
    QVERIFY(!replaceFile(plain("new"), "whole"));
    put(path("plain"), "whole");
    QCOMPARE(bytesOf(path("new")), QByteArray("whole"));
    QCOMPARE(QFileInfo(path("new")).permissions(), QFileInfo(path("plain")).permissions());
    QCOMPARE(contents(), QStringList({"new", "plain"}));
}

void TestWholeFile::permissionsStay() {
    put(path("f"), "old");
    QVERIFY(QFile::setPermissions(path("f"),
                                  QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup | QFile::ExeOther));
    const auto permissions = QFileInfo(path("f")).permissions();
    QVERIFY(!replaceFile(plain("f"), "new"));
    QCOMPARE(bytesOf(path("f")), QByteArray("new"));
    QCOMPARE(QFileInfo(path("f")).permissions(), permissions);
}

void TestWholeFile::aLinkStaysALinkToTheFile() {
    QVERIFY(QDir(m_place->path()).mkdir("sub"));
    put(path("sub/f"), "old");
    QVERIFY(QFile::link("sub/f", path("near")));
    QVERIFY(QFile::link("near", path("far")));
    QVERIFY(QFile::link("sub/later", path("dangling")));
    QVERIFY(!replaceFile(plain("far"), "new"));
    QVERIFY(!replaceFile(plain("dangling"), "made"));
    QCOMPARE(bytesOf(path("sub/f")), QByteArray("new"));
    QCOMPARE(bytesOf(path("sub/later")), QByteArray("made"));
    for (const char* link : {"near", "far", "dangling"}) QVERIFY(QFileInfo(path(link)).isSymLink());
}

void TestWholeFile::nothingIsSeenBeforeItIsCommitted() {
    put(path("f"), "old");
    {
        WholeFile file(plain("f"));
        QVERIFY(!file.open());
        QVERIFY(!file.write("new"));
        QCOMPARE(bytesOf(path("f")), QByteArray("old"));
    }
    QCOMPARE(bytesOf(path("f")), QByteArray("old"));
    QCOMPARE(contents(), QStringList{"f"});
    WholeFile file(plain("f"));
    QVERIFY(!file.open());
    for (const char* part : {"in ", "", "parts"}) QVERIFY(!file.write(part));
    QVERIFY(!file.commit());
    QCOMPARE(bytesOf(path("f")), QByteArray("in parts"));
    QCOMPARE(contents(), QStringList{"f"});
}

// The limit on the size of files stands for the end of the disk.
void TestWholeFile::aFailureLeavesTheFileAsItWas() {
    put(path("f"), "old");
    rlimit before{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit little{.rlim_cur = 1000, .rlim_max = before.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &little), 0);
    const WriteFailure failure = replaceFile(plain("f"), std::string(2000, 'x'));
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &before), 0);
    QCOMPARE(failure.reason, writeFailure(EFBIG).reason);
    QVERIFY(!failure.isFull);
    QCOMPARE(bytesOf(path("f")), QByteArray("old"));
    QCOMPARE(contents(), QStringList{"f"});
    QVERIFY(writeFailure(ENOSPC).isFull);
    QVERIFY(notWritten("f", writeFailure(ENOSPC)).text().find("free some space") != std::string::npos);
}

void TestWholeFile::obstaclesAreNamed() {
    QCOMPARE(replaceFile(plain("nowhere/f"), "x").reason, writeFailure(ENOENT).reason);
    QVERIFY(replaceFile(m_place->path().toStdString(), "x"));
    QVERIFY(QFile::link("circle", path("circle")));
    QVERIFY(replaceFile(plain("circle/f"), "x"));
    QCOMPARE(contents(), QStringList{"circle"});
}

QTEST_GUILESS_MAIN(TestWholeFile)
#include "tst_whole_file.moc"
