// SPDX-License-Identifier: MIT
#pragma once

#include <QEventLoop>
#include <QSerialPort>
#include <QString>
#include <functional>

#include "link/connection/transport.h"
#include "link/ports/linerate.h"
#include "protocol/baud.h"

namespace nmc {

/// A serial port through QSerialPort, 8N1, no flow control. The port is used exclusively: besides Qt's lock
/// file, which is based on the name, the descriptor is locked with flock, which also covers other names of
/// the port and root.
class SerialTransport : public Transport {
public:
    /// Reads the rate that a descriptor actually has, where the driver reports it.
    using RateReader = std::function<std::optional<std::uint32_t>(int)>;

    /// `baud`: the rate that will be needed later. open() checks that the adapter can generate it before any
    /// byte is sent.
    explicit SerialTransport(QString port, std::uint32_t baud = kPowerUpBaud, RateReader realRate = lineRate);
    ~SerialTransport() override;

    tl::expected<void, PortError> open() override;
    tl::expected<void, PortError> setBaud(std::uint32_t baud) override;
    tl::expected<void, PortError> send(ByteSpan bytes) override;
    void discardInput() override;
    Received receive(std::optional<TimePoint> until, int wakeFd) override;
    [[nodiscard]] int fd() const override { return m_port.handle(); }

private:
    [[nodiscard]] PortError openError() const;
    [[nodiscard]] PortError gone() const;
    [[nodiscard]] PortError problem(PortProblem what, const QString& detail) const;

    QString m_name;
    std::uint32_t m_baud;
    RateReader m_realRate;
    /// Never run: it provides the event dispatcher that a port requires, in a thread not started by Qt.
    QEventLoop m_dispatcher;
    QSerialPort m_port;
};

}  // namespace nmc
