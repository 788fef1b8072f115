// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a drill string of a uniform rod, or a uniform rod of a string, and says what that has lost.
#pragma once

#include <QAction>

#include "core/model/form_conversion.h"
#include "ui/document/document.h"
#include "ui/window/notice.h"

namespace drillwave {

class FormNotice : public Notice {
    Q_OBJECT

  public:
    /// The document must outlive it.
    explicit FormNotice(Document& document, QWidget* parent = nullptr);

    /// For a menu; each is disabled where there is nothing to convert, with the reason as its tooltip.
    QAction* toString() const { return m_toString; }
    QAction* toUniformRod() const { return m_toUniformRod; }
    QAction* toRig() const { return m_toRig; }      ///< of dimensionless groups, by a RigDialog
    QAction* toForce() const { return m_toForce; }  ///< in place of the hammer of a string

  private:
    void convert(const Conversion& conversion, const QString& step, const QString& done);
    void offer();

    Document& m_document;
    QAction* m_toString;
    QAction* m_toUniformRod;
    QAction* m_toForce;
    QAction* m_toRig;
    bool m_isConverting = false;
};

}  // namespace drillwave
