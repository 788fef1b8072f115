// SPDX-License-Identifier: GPL-3.0-or-later
// The threads that a process may keep busy: those of its job, not those of the machine.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <sched.h>

#include "core/numeric/available_threads.h"
#include "tests/support/files.h"

using namespace drillwave;
using namespace drillwave::test;

class TestAvailableThreads : public QObject {
    Q_OBJECT

  private slots:
    void affinityBoundsTheThreads();
    void quotaIsTheSmallestOfTheGroupsAbove_data();
    void quotaIsTheSmallestOfTheGroupsAbove();
    void quotaIsRoundedUpWithinTheProcessors();
};

void TestAvailableThreads::affinityBoundsTheThreads() {
    cpu_set_t before;
    QCOMPARE(::sched_getaffinity(0, sizeof before, &before), 0);
    int first = 0;
    while (!CPU_ISSET(first, &before)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    QCOMPARE(::sched_setaffinity(0, sizeof one, &one), 0);
    const int threads = availableThreads();
    QCOMPARE(::sched_setaffinity(0, sizeof before, &before), 0);
    QCOMPARE(threads, 1);
    QVERIFY(availableThreads() <= CPU_COUNT(&before));
}

void TestAvailableThreads::quotaIsTheSmallestOfTheGroupsAbove_data() {
    QTest::addColumn<QByteArray>("groups");
    QTest::addColumn<double>("processors");  // 0 for no quota
    QTest::newRow("none") << QByteArray("0::/free\n") << 0.0;
    QTest::newRow("version 2") << QByteArray("0::/job\n") << 1.5;
    QTest::newRow("version 2, smaller above") << QByteArray("0::/job/wide/step\n") << 1.5;
    QTest::newRow("version 2, smaller below") << QByteArray("0::/job/narrow\n") << 0.5;
    QTest::newRow("container, whose groups have other names here")
        << QByteArray("0::/docker/0123/init\n") << 0.0;
    QTest::newRow("version 1") << QByteArray("5:memory:/old\n4:cpu,cpuacct:/old/step\n") << 3.0;
    QTest::newRow("version 1, no quota") << QByteArray("4:cpu,cpuacct:/\n") << 0.0;
    QTest::newRow("other controllers only") << QByteArray("5:cpuset:/job\n") << 0.0;
    QTest::newRow("not a list of groups") << QByteArray("nonsense\n:\n\n0:") << 0.0;
    QTest::newRow("empty") << QByteArray() << 0.0;
}

void TestAvailableThreads::quotaIsTheSmallestOfTheGroupsAbove() {
    QFETCH(QByteArray, groups);
    QFETCH(double, processors);
    const QTemporaryDir root;
    const auto put = [&](const QString& folder, const QString& name, const QByteArray& text) {
        QVERIFY(QDir(root.path()).mkpath(folder));
        write(root.filePath(folder + "/" + name), text);
    };
    put("free", "cpu.max", "max 100000\n");
    put("job", "cpu.max", "150000 100000\n");
    put("job/wide", "cpu.max", "800000 100000\n");
    put("job/narrow", "cpu.max", "50000 100000\n");
    put("cpu,cpuacct", "cpu.cfs_quota_us", "-1\n");
    put("cpu,cpuacct", "cpu.cfs_period_us", "100000\n");
    put("cpu,cpuacct/old", "cpu.cfs_quota_us", "300000\n");
    put("cpu,cpuacct/old", "cpu.cfs_period_us", "100000\n");
    QCOMPARE(processorQuota(groups.toStdString(), root.path().toStdString()).value_or(0), processors);
}

void TestAvailableThreads::quotaIsRoundedUpWithinTheProcessors() {
    QCOMPARE(threadsWithin(8, std::nullopt), 8);
    QCOMPARE(threadsWithin(8, 1.5), 2);
    QCOMPARE(threadsWithin(8, 0.1), 1);
    QCOMPARE(threadsWithin(8, 64.0), 8);
    QCOMPARE(threadsWithin(1, 2.0), 1);
}

QTEST_GUILESS_MAIN(TestAvailableThreads)
#include "tst_available_threads.moc"
