// SPDX-License-Identifier: GPL-3.0-or-later
// Titles, names and paths that look like markup, or that a terminal would obey, in all that is handed over.
#include <QTest>

#include <QDirIterator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

/// As YAML writes it: markup, a control character, one of C1 that begins a command of a terminal, one that
/// turns the direction of reading.
const QByteArray title = "\"A & B </title><script>alert(1)</script> \\x01 \\x9b31m \\u202Eright\"";
const QString shownTitle = "A & B </title><script>alert(1)</script> \\x01 \\u009B31m \\u202Eright";
const QByteArray name = "\"<b>rod & \\\"co\\\"</b>\"";

const QByteArray rod =
    "drillwave: 1\ntitle: " + title +
    "\nrod: {length: 3.66 m, diameter: 39 mm, density: 7850 kg/m^3, youngs_modulus: 206 GPa}\n"
    "pulse: {shape: rectangular, duration: 60 us, force: 200 kN}\n"
    "bit_rock: {stiffness: 100 MN/m, gamma: 0.2, gap: 0 mm}\n"
    "drill: {blow_frequency: 50 Hz, thrust: 5 kN}\n";
const QByteArray drillString = "drillwave: 2\ntitle: " + title +
                               "\nhammer: {velocity: 10 m/s, sections: [{name: " + name +
                               ", length: 300 mm, diameter: 50 mm}]}\n"
                               "string:\n  - {name: " +
                               name +
                               ", length: 3 m, diameter: 39 mm, loss: 2 %}\n"
                               "  - {name: bit, length: 70 mm, diameter: 60 mm}\n"
                               "bit_rock: {stiffness: 100 MN/m, gamma: 0.2, gap: 0 mm}\n"
                               "drill: {blow_frequency: 50 Hz, thrust: 5 kN}\n";

/// Whether a text holds characters that a file to hand over and a terminal must not.
bool isObeyed(const QString& text) {
    static const QRegularExpression obeyed("[\\x{0001}-\\x{0008}\\x{007F}-\\x{009F}\\x{202A}-\\x{202E}]");
    return text.contains(obeyed);
}

/// The text of the first element of that name; nothing where the bytes are no XML or hold a script.
QString elementOf(const QByteArray& bytes, const char* element) {
    QXmlStreamReader xml(bytes);
    QString text;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1StringView("script")) return {};
        if (text.isEmpty() && xml.name() == QLatin1StringView(element)) text = xml.readElementText();
    }
    return xml.hasError() || isObeyed(QString::fromUtf8(bytes)) ? QString() : text;
}

}  // namespace

class TestHostileTexts : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        m_place = std::make_unique<QTemporaryDir>(QDir::tempPath() + "/a & <b>XXXXXX");
        write(path("rod <i>.yaml"), rod);
        write(path("string <i>.yaml"), drillString);
    }
    void everyPictureIsXml_data();
    void everyPictureIsXml();
    void aReportHoldsNoMarkupOfATitle();
    void nothingPrintedMovesATerminal();

  private:
    QString path(const QString& file) const { return m_place->filePath(file); }
    QStringList withPaths(QStringList words) const {
        return words.replaceInStrings("ROD", path("rod <i>.yaml"))
            .replaceInStrings("STRING", path("string <i>.yaml"))
            .replaceInStrings("OUT", path("out & <o>"));
    }
    std::unique_ptr<QTemporaryDir> m_place;
};

void TestHostileTexts::everyPictureIsXml_data() {
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* words) { QTest::newRow(words) << QString(words).split(' '); };
    row("run ROD -o OUT");
    row("run STRING -o OUT");
    row("sweep ROD --vary beta=0.1:10:20:log -o OUT.csv");
    row("curve ROD --along beta=0.1:10 -o OUT.csv");
    row("map ROD --x beta=0.1:10:5 --y gamma=0.1:1:5 -o OUT.csv");
    row("gap ROD -o OUT.csv");
    row("thrust STRING --along drill.blow_frequency=20Hz:60Hz:3 -o OUT.csv");
    row("drill ROD --blows 20 --cells 10 -o OUT.csv");
    row("drill ROD --scan drill.thrust=3kN:6kN:2 --blows 20 --cells 10 -o OUT.csv");
    row("design ROD --choose rod.length=3m,4m --uncertain gamma=0.1:0.3 --aim max:efficiency@mean --samples "
        "64 -o OUT");
    row("accuracy ROD --segments 50,100,200 -o OUT");
}

void TestHostileTexts::everyPictureIsXml() {
    QFETCH(QStringList, words);
    const Finished finished = run(withPaths(words) + QStringList{"--plots", "svg,pdf,png"});
    QVERIFY2(finished.exitCode == 0, finished.error);
    QDirIterator pictures(m_place->path(), {"*.svg"}, QDir::Files, QDirIterator::Subdirectories);
    int count = 0;
    for (; pictures.hasNext(); ++count) {
        const QByteArray svg = read(pictures.next());
        const QString found = elementOf(svg, "title");
        // A picture of accuracy has no title.
        QVERIFY2(words[0] == "accuracy" || found.startsWith(shownTitle), svg.left(800));
        QVERIFY2(!elementOf(svg, "desc").isEmpty(), svg.left(800));
    }
    QVERIFY(count > 0);
}

void TestHostileTexts::aReportHoldsNoMarkupOfATitle() {
    for (const char* file : {"ROD", "STRING"}) {
        const Finished finished = run(
            withPaths({"report", file, "--project", "<script>alert(2)</script>", "-o", "OUT/", "--force"}));
        QVERIFY2(finished.exitCode == 0, finished.error);
        const QString html = QString::fromUtf8(read(path("out & <o>/report.html")));
        QVERIFY(!html.contains("<script>alert") && !html.contains("</title><script>"));
        QVERIFY(html.contains("<title>A &amp; B &lt;/title&gt;&lt;script&gt;alert(1)"));
        QVERIFY(!isObeyed(html));
        static const QRegularExpression picture("data:image/svg\\+xml;base64,([A-Za-z0-9+/=]+)");
        int count = 0;
        for (auto found = picture.globalMatch(html); found.hasNext(); ++count) {
            const QByteArray svg = QByteArray::fromBase64(found.next().captured(1).toLatin1());
            QVERIFY2(!elementOf(svg, "title").isEmpty(), svg.left(800));
        }
        QVERIFY(count > 2);
        QVERIFY(read(path("out & <o>/report.pdf")).startsWith("%PDF-"));
    }
}

void TestHostileTexts::nothingPrintedMovesATerminal() {
    for (const char* line :
         {"run ROD", "run STRING", "run ROD --json", "thrust ROD", "gap ROD", "gap ROD --json",
          "drill ROD --blows 20 --cells 10", "accuracy ROD --segments 50,100", "validate ROD",
          "curve ROD --along beta=0.1:10", "map ROD --x beta=0.1:10:3 --y gamma=0.1:1:3 --json"}) {
        const Finished finished = run(withPaths(QString(line).split(' ')));
        QVERIFY2(finished.exitCode == 0, finished.error);
        QVERIFY2(!isObeyed(QString::fromUtf8(finished.out + finished.error)), line);
    }
    const Finished refused = run({"run", QString::fromUtf8("\x1b[31m\xc2\x9b.yaml")});
    QCOMPARE(refused.exitCode, 3);
    QVERIFY2(!isObeyed(QString::fromUtf8(refused.error)), refused.error);
}

QTEST_GUILESS_MAIN(TestHostileTexts)
#include "tst_hostile_texts.moc"
