// SPDX-License-Identifier: GPL-3.0-or-later
// packaging/run on a bare system, whose commands are stood in for: what it asks for, shows and leaves behind.
#include <QtTest>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

/// A copy of packaging/ beside a finished program, and stand-ins for the commands it uses.
class BareSystem {
  public:
    BareSystem() {
        for (const char* folder : {"bin", "tmp", "repo/packaging", "repo/build/release/app"})
            QDir(m_folder.path()).mkpath(folder);
        for (const char* name : {"run", "test", "dependencies.sh"})
            put(QStringLiteral("repo/packaging/") + name,
                read(QStringLiteral(DRILLWAVE_SOURCE_DIR "/packaging/") + name));
        put("repo/build/release/app/drillwave", "#!/bin/sh\nexit 0\n");
        put("bin/dpkg", "#!/bin/sh\nexit 1\n");
        put("bin/sudo", "#!/bin/sh\n[ \"$1\" = -n ] || exec \"$@\"\n");
        put("bin/apt-get",
            "#!/bin/bash\necho \"$*\" >> $BARE/calls\n"
            "for word in \"$@\"; do\n"
            "  case $word in Dir::Cache::archives=*) touch \"${word#*=}/fetched.deb\";; esac\n"
            "done\n"
            "case \"$*\" in *assume-no*) echo 'Need to get 298 MB of archives.'; exit 1;; esac\n"
            "for i in $(seq 250); do echo \"Unpacking package $i\"; done\n");
        put("bin/cmake",
            "#!/bin/bash\n[ \"$1\" = --build ] || exit 0\n"
            "for i in $(seq 100); do\n"
            "  echo \"[$i/100] Building x$i\"\n"
            "  [ -z \"$BROKEN\" ] || [ $i -lt 40 ] || "
            "{ printf 'FAILED: x\\nx.cpp:1: error: first\\nx.cpp:2: error: last\\n'; exit 1; }\n"
            "done\n");
    }

    Finished packagingRun(const QProcessEnvironment& more = {}) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) environment.remove(name);
        environment.insert(more);
        environment.insert("PATH", m_folder.filePath("bin") + ":" + environment.value("PATH"));
        environment.insert("TMPDIR", m_folder.filePath("tmp"));
        environment.insert("BARE", m_folder.path());
        QProcess process;
        process.setProcessEnvironment(environment);
        process.start(m_folder.filePath("repo/packaging/run"), QStringList());
        if (!process.waitForFinished(60000)) return {};
        return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    }

    QByteArray calls() const { return read(m_folder.filePath("calls")); }
    QStringList leftBehind() const {
        return QDir(m_folder.filePath("tmp")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
    }

  private:
    void put(const QString& path, const QByteArray& bytes) const {
        const QString absolute = m_folder.filePath(path);
        write(absolute, bytes);
        QFile::setPermissions(absolute, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }

    QTemporaryDir m_folder;
};

}  // namespace

class TestPackaging : public QObject {
    Q_OBJECT

  private slots:
    void whatIsFetchedIsToldAndRemoved() {
        const BareSystem system;
        const Finished finished = system.packagingRun();
        QVERIFY2(finished.exitCode == 0, finished.error);
        // Those of packaging/test, too: an administrator is asked once.
        QVERIFY(finished.out.contains("installing missing packages: g++ ") &&
                finished.out.contains(" locales\n"));
        QVERIFY(finished.out.contains("298 MB"));
        QVERIFY(finished.out.contains("Unpacking package 200\n"));
        QVERIFY(system.calls().contains("Dir::Cache::archives="));
        QCOMPARE(system.leftBehind(), QStringList());
    }

    void aBuildShowsHowFarItIs() {
        const BareSystem system;
        const Finished finished = system.packagingRun();
        for (const char* part : {"[10/100]\n", "[50/100]\n", "[100/100]\n"})
            QVERIFY2(finished.out.contains(part), finished.out);
    }

    void errorsOfTheCompilerAreShownInFull() {
        const BareSystem system;
        QProcessEnvironment broken;
        broken.insert("BROKEN", "1");
        const Finished finished = system.packagingRun(broken);
        QVERIFY(finished.exitCode != 0);
        QVERIFY2(finished.error.contains("error: first\n") && finished.error.contains("error: last\n"),
                 finished.error);
        QCOMPARE(system.leftBehind(), QStringList());
    }
};

QTEST_GUILESS_MAIN(TestPackaging)
#include "tst_packaging.moc"
