// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <functional>

class QAction;
class QMainWindow;
class QSettings;

namespace nmc {

/// The layouts of a window for its tasks: which docks are open, where they are, and how much room each has.
/// Each layout is restored as the user left it.
class Layouts : public QObject {
    Q_OBJECT

public:
    enum class Kind : quint8 {
        Operate,  ///< motions, with everything around them
        Tune,     ///< plots, with gains and step beside them
        Chain,    ///< modules, packets and messages
    };

    /// `window` and `settings` must outlive it. `arrange` puts the docks into the initial arrangement of a
    /// layout.
    Layouts(QMainWindow& window, QSettings& settings, std::function<void(Kind)> arrange);

    [[nodiscard]] const QList<QAction*>& actions() const { return m_actions; }
    [[nodiscard]] Kind kind() const { return m_kind; }
    /// Restores the layout that was chosen last, as it was left; call it once the window has its docks and
    /// its size.
    void restore();
    void save();
    /// Returns the chosen layout to its initial arrangement.
    void reset();

signals:
    /// The docks have been arranged already.
    void chosen(nmc::Layouts::Kind kind);

private:
    void add(const QString& objectName, const QString& text, const QString& meaning, const QKeySequence& key);
    void choose(Kind kind);
    void show();

    QMainWindow& m_window;
    QSettings& m_settings;
    std::function<void(Kind)> m_arrange;
    QList<QAction*> m_actions;  ///< in the order of Kind
    Kind m_kind = Kind::Operate;
};

}  // namespace nmc
