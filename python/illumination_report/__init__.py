# SPDX-License-Identifier: BSD-3-Clause
"""A report on a lit surface, as one HTML page that can be handed on. For ParaView's Python."""

from .report import write_report

__all__ = ["write_report"]
