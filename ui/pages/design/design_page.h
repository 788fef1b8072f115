// SPDX-License-Identifier: GPL-3.0-or-later
// The page Design: the design that is best for uncertain inputs (theory §12).
#pragma once

#include "ui/job/study_job.h"
#include "ui/pages/design/design_answer.h"
#include "ui/pages/design/design_units.h"
#include "ui/pages/study/study_page.h"

class QCPAxisRect;
class QCheckBox;
class QLabel;
class QPushButton;

namespace drillwave {

class AimRows;
class ChoiceBox;
class DesignCard;
class FigureFrame;
class PresetTicks;
class RangeRows;

class DesignPage : public StudyPage {
    Q_OBJECT

  public:
    explicit DesignPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Design"); }
    QString command() const override;
    void copyCommand() override;
    /// Replaces the uncertain inputs by draws: a table of samples, as read by `design --draws`. Each row has
    /// values of all inputs that are possible together. The draws stay until the user removes them or opens
    /// another document. `source` names the record that they were computed from. An invalid table is ignored.
    void takeDraws(const QString& source, const QByteArray& table);
    void addTo(ReportStudies& studies) const override;
    /// Returns how many studies the page has started, for tests.
    int studies() const { return m_study.started(); }
    FigureFrame& figureFrame() const { return *m_frame; }
    const DesignCard& card() const { return *m_card; }
    /// Returns the answer that is shown or being refined; nullptr before the first one.
    const DesignAnswer* answer() const { return m_study.value(); }

  protected:
    void ask() override;
    void present() override;
    QString obstacle() const override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    /// Study that the controls describe, or the reason why they describe none.
    struct Wish {
        std::optional<DesignStudy> study;
        QString problem;
    };
    Wish wish() const;
    /// Draws (rows of input values that belong together) with the table and the name of the record they come
    /// from.
    struct GivenDraws {
        QString source;
        QByteArray table;
        Draws draws;
    };
    QWidget* makeQuestions();
    QWidget* makeDrawsLine();
    void setDraws(std::optional<GivenDraws> draws);
    QString drawsFile() const;
    QString inputProblem() const;
    void forget();
    void followScenario();
    void chooseSamples(int samples);
    void showSetup(const DesignSetup& setup);
    bool canKeepEnergy() const;
    DesignSetup setup() const;
    void keepSetup();
    void excludePresetKeys();
    void refine();
    void showRefine(const DesignAnswer& answer);
    bool choosesPresets() const;
    void takeDesign(std::uint64_t design, Qt::KeyboardModifiers modifiers);
    void draw(const DesignAnswer& answer);
    void refuse(const QString& why);
    void showHere();
    void showRuns();
    std::optional<QPointF> placeOf(const SolvedBlow& blow) const;
    ShownUnits shownUnitsOf(const Scenario& base) const;
    std::vector<ParameterValue> valuesOf(std::uint64_t design) const;
    void click(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    void loadWorst(std::size_t aim);

    RangeRows* m_uncertain = nullptr;
    RangeRows* m_choices = nullptr;
    AimRows* m_aims = nullptr;
    PresetTicks* m_presets = nullptr;
    QCheckBox* m_keepEnergy = nullptr;
    QPushButton* m_refine = nullptr;
    QWidget* m_drawsLine = nullptr;
    QLabel* m_drawsText = nullptr;
    std::optional<GivenDraws> m_draws;
    QPushButton* m_load = nullptr;  // loads the recommended design
    ChoiceBox* m_samples = nullptr;
    DesignCard* m_card;
    FigureFrame* m_frame = nullptr;
    int m_plotLines;  // least height of the plot in lines, without its legend
    QString m_problem;
    QString m_headline, m_sentence;  // sentences for the answer shown
    int m_usualSamples = 0;          // default number of samples for the present scenario
    std::shared_ptr<const DesignAnswer> m_shown;
    ShownUnits m_shownUnits;
    DesignSetup m_setup;                   // setup of the document when it was last shown
    bool m_isSetUp = false;                // whether the controls show the setup of the document
    std::optional<DesignStudy> m_refined;  // study that may run without time limit
    // Destroyed first, because its thread uses other members.
    StudyRunner<DesignQuestion, DesignAnswer> m_study;
};

}  // namespace drillwave
