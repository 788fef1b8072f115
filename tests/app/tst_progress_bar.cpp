// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of long work where nobody looks at a terminal.
#include <QTest>

#include <cstdio>

#include "app/progress_bar.h"

using namespace drillwave;

class TestProgressBar : public QObject {
    Q_OBJECT

  private slots:
    void aLogGetsWholeLines() {
        std::FILE* log = std::tmpfile();
        QVERIFY(log);
        {
            ProgressBar bar(200, "rows", plainStyle(), {.stream = log, .between = {}});
            for (const std::uint64_t done : {50, 100, 200}) bar.show(done);
        }
        const QList<QByteArray> lines = contents(log).split('\n');
        QCOMPARE(lines.size(), 4);
        QVERIFY2(lines[0].startsWith("25 % done  ") && lines[0].contains(" rows/s  "), lines[0]);
        QVERIFY2(lines[0].endsWith(" left"), lines[0]);
        QVERIFY(lines[1].startsWith("50 % done") && lines[2].startsWith("100 % done"));
        QCOMPARE(lines[3], QByteArray());
    }

    void quickWorkLeavesALogEmpty() {
        std::FILE* log = std::tmpfile();
        QVERIFY(log);
        {
            ProgressBar bar(200, {}, plainStyle(), {.stream = log, .between = std::chrono::hours(1)});
            for (std::uint64_t done = 0; done <= 200; ++done) bar.show(done);
        }
        QCOMPARE(contents(log), QByteArray());
    }

  private:
    static QByteArray contents(std::FILE* log) {
        std::rewind(log);
        char bytes[1000];
        const std::size_t size = std::fread(bytes, 1, sizeof bytes, log);
        std::fclose(log);
        return {bytes, static_cast<qsizetype>(size)};
    }
};

QTEST_GUILESS_MAIN(TestProgressBar)
#include "tst_progress_bar.moc"
