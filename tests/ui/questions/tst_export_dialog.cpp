// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog for files to be written: the chosen format decides where the name says none.
#include <QComboBox>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

#include "ui/questions/export_dialog.h"

using namespace drillwave;

class TestExportDialog : public QObject {
    Q_OBJECT

  private slots:
    void theFilterDecidesWhereTheNameSaysNothing_data();
    void theFilterDecidesWhereTheNameSaysNothing();
};

void TestExportDialog::theFilterDecidesWhereTheNameSaysNothing_data() {
    QTest::addColumn<int>("filter");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("chosen");
    QTest::newRow("the first one") << 0 << "t38"
                                   << "t38.html";
    QTest::newRow("another one") << 1 << "t38"
                                 << "t38.pdf";
    QTest::newRow("all files") << 2 << "t38"
                               << "t38.html";
    QTest::newRow("back to the first one") << 3 << "t38"
                                           << "t38.html";
    QTest::newRow("the name says") << 1 << "t38.html"
                                   << "t38.html";
}

void TestExportDialog::theFilterDecidesWhereTheNameSaysNothing() {
    QFETCH(int, filter);
    QFETCH(QString, typed);
    QFETCH(QString, chosen);
    const QTemporaryDir folder;
    ExportDialog dialog(nullptr, QStringLiteral("Write"), folder.filePath("t38_report.html"),
                        QStringLiteral("Web page (*.html);;PDF (*.pdf);;All files (*)"));
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.show();
    auto& filters = *dialog.findChild<QComboBox*>(QStringLiteral("fileTypeCombo"));
    for (int step = 0; step < filter; ++step)
        QTest::keyClick(&filters, filter == 3 && step > 0 ? Qt::Key_Home : Qt::Key_Down);
    auto& name = *dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    name.clear();
    QTest::keyClicks(&name, typed);
    QCOMPARE(dialog.selectedFiles(), QStringList(folder.filePath(chosen)));
}

QTEST_MAIN(TestExportDialog)
#include "tst_export_dialog.moc"
