// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that come from what is not a file, in process.
#include <sys/stat.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "app/command_error.h"
#include "app/input_text.h"

using namespace drillwave;

namespace {

constexpr std::uint64_t most = 1 << 20;

/// Everything that is kept of a named pipe into which so many bytes are written.
std::string keptOf(const std::string& pipe, std::uint64_t bytes) {
    std::jthread writer([&] { std::ofstream(pipe) << std::string(bytes, 'x'); });
    RereadableInput input(pipe, most);
    return {std::istreambuf_iterator<char>(input.stream()), {}};
}

}  // namespace

class TestInputText : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_before = qgetenv("TMPDIR");
        qputenv("TMPDIR", m_folder->path().toUtf8());
    }
    void cleanup() {
        QVERIFY(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
        m_before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", m_before);
    }

    void whatHasNoEndIsRefused() {
        try {
            RereadableInput("/dev/zero", most);
            QFAIL("taken");
        } catch (const CommandError& error) {
            QCOMPARE(error.code(), ExitCode::unreadableInput);
            const std::string line = error.lines().front();
            QVERIFY2(line.starts_with("/dev/zero: is longer than 1 MiB"), line.c_str());
        }
    }

    void allOfAPipeIsKeptUpToTheBound() {
        const QTemporaryDir folder;
        const std::string pipe = folder.filePath("pipe").toStdString();
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        QCOMPARE(keptOf(pipe, most).size(), std::size_t{most});
        QVERIFY_EXCEPTION_THROWN(keptOf(pipe, most + 1), CommandError);
    }

  private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QByteArray m_before;
};

QTEST_GUILESS_MAIN(TestInputText)
#include "tst_input_text.moc"
