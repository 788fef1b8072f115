// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is killed while it saves leaves the old file or the new one, whole.
#include <QDir>
#include <QFile>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include "core/yaml/examples.h"
#include "tests/support/child_process.h"
#include "tests/support/files.h"
#include "tests/support/tries.h"
#include "ui/document/document.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const int rounds = tries("DRILLWAVE_TRIAL", 20, 100);

// 300 kB: many times what the system writes at once.
QByteArray largeScenario(const QByteArray& remark) {
    QByteArray bytes;
    while (bytes.size() < 300'000) bytes += "# " + remark + ' ' + QByteArray::number(bytes.size()) + '\n';
    return bytes + QByteArray(defaultExample().text.data(), qsizetype(defaultExample().text.size()));
}

// Saves two scenarios in turn until it is killed.
int saveForEver(const QStringList& words) {
    Document first;
    Document second;
    if (!first.open(words[0]).isEmpty() || !second.open(words[1]).isEmpty()) return 1;
    for (bool ready = false;;) {
        if (!first.save(words[2]).isEmpty() || !second.save(words[2]).isEmpty()) return 1;
        if (!std::exchange(ready, true)) sayReady();
    }
}

}  // namespace

class TestKilledSaves : public QObject {
    Q_OBJECT

  private slots:
    void theFileIsAlwaysTheOldOrTheNewOneWhole();
};

void TestKilledSaves::theFileIsAlwaysTheOldOrTheNewOneWhole() {
    const QTemporaryDir folder;
    const QByteArray first = largeScenario("first");
    const QByteArray second = largeScenario("second");
    const QStringList words{folder.filePath(QStringLiteral("first.yaml")),
                            folder.filePath(QStringLiteral("second.yaml")),
                            folder.filePath(QStringLiteral("saved/target.yaml"))};
    for (int i : {0, 1}) {
        QFile file(words[i]);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(i == 0 ? first : second) > 0);
    }
    QRandomGenerator random(1);
    int firsts = 0;
    for (int round = 0; round < rounds; ++round) {
        QDir saved(folder.filePath(QStringLiteral("saved")));
        QVERIFY(saved.removeRecursively() && saved.mkpath(QStringLiteral(".")));
        QProcess child;
        QVERIFY(startChild(child, QStringList{QStringLiteral("--save")} + words));
        // Later and later, so that slow machines too come to the second file.
        QTest::qSleep(random.bounded(5 + round * 100 / rounds));
        QVERIFY(killChild(child));
        const QByteArray left = read(words[2]);
        QVERIFY2(left == first || left == second, qPrintable(QString::number(left.size())));
        firsts += left == first;
    }
    // Some were killed after one of the two, some after the other.
    QVERIFY(firsts > 0 && firsts < rounds);
}

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    const QStringList words = QCoreApplication::arguments();
    if (words.value(1) == QLatin1String("--save")) return saveForEver(words.mid(2));
    TestKilledSaves test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_killed_saves.moc"
