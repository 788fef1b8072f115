// SPDX-License-Identifier: GPL-3.0-or-later
// The page Drilling: sequences of blows with feed force, and scans of such sequences over a parameter
// (drilling §7).
#pragma once

#include "core/report/drilling_figure.h"
#include "ui/job/solved_blow.h"
#include "ui/job/study_job.h"
#include "ui/pages/drilling/drilling_question.h"
#include "ui/pages/drilling/run_means.h"
#include "ui/pages/study/study_page.h"

class QCPAxisRect;
class QCheckBox;
class QPushButton;

namespace drillwave {

class AxisFields;
class DrillingTable;
class FigureFrame;
class MissingFields;
class SectionBox;

/// Page that computes a sequence of many blows, and scans, which compute such a sequence for each value of a
/// parameter.
class DrillingPage : public StudyPage {
    Q_OBJECT

  public:
    explicit DrillingPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Drilling"); }
    bool shows(const Scenario& scenario) const override { return hasUnits(scenario); }
    QString elsewhere() const override;
    /// Returns the exports of the blow sequence and, if there is one, of the scan.
    QList<PageExport> exports() const override;
    QString command() const override;
    void addTo(ReportStudies& studies) const override;
    /// Returns how many blow sequences the page has started, for tests.
    int marches() const { return m_march.started(); }
    /// Returns how many scans (blow sequences over a parameter) the page has started, for tests.
    int scans() const { return m_scan.started(); }
    FigureFrame& figureFrame() const { return *m_frame; }
    /// Returns the blow sequence as far as it is computed; nullptr before the first one.
    const DrillingAnswer* answer() const { return m_march.value(); }
    const DrillingScanAnswer* scanAnswer() const { return m_scan.value(); }
    const StudyActivity& scanActivity() const { return m_scan.job(); }

  public slots:
    /// Starts a scan: a blow sequence for each of several values of a parameter, over the range in the
    /// fields. Does nothing if a field is invalid.
    void scan();

  signals:
    /// Reports that the user wants to see one blow of a sequence in detail; `what` names the blow in words.
    void blowOpened(const drillwave::MarchedQuestion& blow, const QString& what);

  protected:
    void ask() override;
    void present() override;
    void hideEvent(QHideEvent* event) override;
    QString obstacle() const override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    QWidget* makeScanControls();
    DrillingScanQuestion scanQuestion() const;
    std::optional<ShownScan> shownScan() const;
    std::optional<double> placeAlong(const Scenario& of) const;
    void keepBefore();
    void refuse(const std::vector<Message>& problems);
    void draw(const DrillingAnswer& answer);
    void scanIfQuick(const DrillingAnswer& answer);
    void startScan(const DrillingScanQuestion& question);
    void stopScan();
    /// Returns whether the blow sequence belongs to the present scenario and is complete.
    bool isMarchNew() const;
    /// Returns whether the scan belongs to the present scenario and is complete.
    bool isScanNew() const;
    QByteArray scanCsv() const;
    std::string scenarioWith(const DrillingSettings& settings) const;
    QString scanName() const;
    void showScanState();
    QStringList wordsOf(const DrillingAnswer& answer) const;
    void openBlowAt(QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers);
    void takeScanned(QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers);
    void openBlow(long number, Qt::KeyboardModifiers modifiers);
    void showRuns(double lastBlow);

    MissingFields* m_missing;
    AxisFields* m_axis = nullptr;
    QPushButton* m_scanButton = nullptr;
    QCheckBox* m_bracket = nullptr;
    DrillingTable* m_table;
    SectionBox* m_details = nullptr;
    QLabel* m_exponent = nullptr;  // Lyapunov exponent, in the details
    FigureFrame* m_frame = nullptr;
    std::shared_ptr<const DrillingAnswer> m_complete;  // last sequence that was computed to its end
    std::shared_ptr<const DrillingAnswer> m_before;    // sequence of an earlier scenario
    // Whether a scan was stopped because the page was hidden.
    bool m_wantsScan = false;
    StudyRunner<DrillingQuestion, DrillingAnswer> m_march;
    StudyRunner<DrillingScanQuestion, DrillingScanAnswer> m_scan;
    RunDrilling m_runMeans;
};

}  // namespace drillwave
