// SPDX-License-Identifier: GPL-3.0-or-later
// The scripts of packaging/ on a bare system, whose commands are stood in for: what they ask for, show and
// leave behind.
#include <QTest>

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
        for (const char* name :
             {"run", "test", "check-package", "check-sources", "bare_system.sh", "dependencies.sh"})
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

    Finished packagingRun(const QProcessEnvironment& more = {}) const { return packaging("run", more); }
    Finished packagingTest(const QProcessEnvironment& more = {}) const { return packaging("test", more); }
    Finished packagingCheck(const QStringList& words = {}) const {
        return packaging("check-package", {}, words);
    }
    Finished sourcesCheck() const { return packaging("check-sources", {}); }

    /// Replaces a command by a script of bash.
    void standIn(const char* command, const QByteArray& script) const {
        put(QStringLiteral("bin/") + command, "#!/bin/bash\n" + script);
    }

    QByteArray calls() const { return read(m_folder.filePath("calls")); }
    QStringList leftBehind() const {
        return QDir(m_folder.filePath("tmp")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
    }

  private:
    Finished packaging(const QString& command, const QProcessEnvironment& more,
                       const QStringList& words = {}) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "LOCPATH", "LC_ALL"}) environment.remove(name);
        environment.insert(more);
        environment.insert("PATH", m_folder.filePath("bin") + ":" + environment.value("PATH"));
        environment.insert("TMPDIR", m_folder.filePath("tmp"));
        environment.insert("BARE", m_folder.path());
        QProcess process;
        process.setProcessEnvironment(environment);
        process.start(m_folder.filePath("repo/packaging/") + command, words);
        if (!process.waitForFinished(60000)) return {};
        return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    }

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
        // Includes the packages of packaging/test: an administrator is asked once.
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

    void theSeedChoosesTheLocale() {
        const BareSystem system;
        system.standIn("localedef", "");
        system.standIn("locale", "echo ,\n");
        system.standIn("ctest",
                       "echo \"ctest ${LOCPATH:+$LC_ALL} $*\" >> $BARE/calls\n[ -n \"$LOCPATH\" ]\n");
        const auto tested = [&](const char* seed) {
            QProcessEnvironment more;
            more.insert("DRILLWAVE_SEED", seed);
            return system.packagingTest(more);
        };
        QCOMPARE(tested("7").exitCode, 0);
        QVERIFY2(system.calls().contains("ctest de_DE.UTF-8 --preset release"), system.calls());
        QVERIFY2(!system.calls().contains("ctest  --preset release"), system.calls());
        const Finished finished = tested("8");
        QVERIFY2(system.calls().contains("ctest  --preset release"), system.calls());
        QCOMPARE(finished.exitCode, 1);
        QVERIFY2(finished.error.endsWith("packaging/test: failed: the tests in the locale C\n"),
                 finished.error);
    }

    void testsOfABuildThatFailsAreNotRun() {
        const BareSystem system;
        system.standIn("ctest", "echo ctest >> $BARE/calls\n");
        QProcessEnvironment broken;
        broken.insert("BROKEN", "1");
        const Finished finished = system.packagingTest(broken);
        QCOMPARE(finished.exitCode, 1);
        QVERIFY2(!system.calls().contains("ctest"), system.calls());
        QVERIFY2(finished.error.endsWith("packaging/test: failed: the build\n"), finished.error);
    }

    void aSystemOfItsOwnNeedsRoot() {
        const BareSystem system;
        system.standIn("id", "echo 1000\n");
        for (const Finished& finished : {system.packagingCheck(), system.sourcesCheck()}) {
            QCOMPARE(finished.exitCode, 1);
            QVERIFY2(finished.error.contains("needs root"), finished.error);
            QCOMPARE(finished.error.count('\n'), 1);
            QVERIFY2(finished.out.isEmpty(), finished.out);
        }
    }

    void aSystemThatCannotBeMadeIsToldAndLeavesNothing() {
        const BareSystem system;
        system.standIn("id", "echo 0\n");
        for (const char* tool : {"dpkg-shlibdeps", "file", "git", "lintian"}) system.standIn(tool, "");
        system.standIn("cpack", "mkdir -p ${@: -1} && touch ${@: -1}/drillwave_1.deb\n");
        system.standIn("debootstrap", "echo 'E: no such mirror'; exit 1\n");
        const Finished finished = system.packagingCheck();
        QCOMPARE(finished.exitCode, 1);
        QVERIFY2(finished.error.endsWith("packaging/check-package: E: no such mirror\n"), finished.error);
        const Finished sources = system.sourcesCheck();
        QCOMPARE(sources.exitCode, 1);
        QVERIFY2(sources.error.endsWith("packaging/check-sources: E: no such mirror\n"), sources.error);
        QCOMPARE(system.leftBehind(), QStringList());
    }

    void whatOneCommandNeedsMoreIsInstalledToo() {
        const BareSystem system;
        for (const char* tool : {"dpkg-shlibdeps", "file", "lintian", "dpkg-deb", "timeout"})
            system.standIn(tool, "");
        system.standIn("cpack", "mkdir -p ${@: -1} && touch ${@: -1}/drillwave_1.deb\n");
        const Finished finished = system.packagingCheck({"--unpacked"});
        QCOMPARE(finished.exitCode, 1);  // nothing is in these packages
        QVERIFY2(finished.out.contains("unpacked:\n  FAILED  a blow"), finished.out);
        QVERIFY2(finished.error.endsWith("what FAILED above\n"), finished.error);
        QVERIFY2(system.calls().contains(" locales dpkg-dev file"), system.calls());
        QCOMPARE(system.leftBehind(), QStringList());
    }

    void wordsThatACheckDoesNotKnowAreRefused() {
        const BareSystem system;
        system.standIn("id", "echo 0\n");
        for (const Finished& finished :
             {system.packagingCheck({"--unpakced"}), system.packagingCheck({"a", "b"})}) {
            QCOMPARE(finished.exitCode, 2);
            QVERIFY2(finished.error.contains("--unpacked"), finished.error);
        }
    }

    void whatIsMissingIsNamedWhereNothingIsMounted() {
        const BareSystem system;
        system.standIn("mountpoint", "exit 1\n");
        for (const Finished& finished : {system.packagingRun(), system.packagingTest()}) {
            QCOMPARE(finished.exitCode, 1);
            QVERIFY2(finished.error.contains("/proc is not mounted here"), finished.error);
            QCOMPARE(finished.error.count('\n'), 1);
        }
    }
};

QTEST_GUILESS_MAIN(TestPackaging)
#include "tst_packaging.moc"
