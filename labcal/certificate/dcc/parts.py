"""The pieces that a DCC is put together from: texts, contacts, numbers with their uncertainties."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy  # its parts load where they are used: labcal starts a fifth sooner
from numpy.typing import ArrayLike

from labcal.certificate.dcc.units import product, si_unit
from labcal.record.administrative import Address

DCC, SI = "https://ptb.de/dcc", "https://ptb.de/si"
COVERAGE, PROBABILITY = 2, 0.95
LANGUAGE = "en"


@dataclass(frozen=True, slots=True)
class Makers:
    """The makers of elements of the two namespaces (`lxml.builder.ElementMaker`)."""

    d: Any
    si: Any

    def text(self, tag: str, words: str, ref_type: str = "") -> Any:
        """A dcc:`tag` with words in the certificate's language."""
        return getattr(self.d, tag)(self.d.content(words, lang=LANGUAGE), **_ref_type(ref_type))

    def contact(self, who: Address) -> list[Any]:
        """Name, how to reach them, and where, as a dcc:contactType has them."""
        d, reach = self.d, []
        reach += [d.eMail(who.email)] if who.email else []
        reach += [d.phone(who.phone)] if who.phone else []
        place = [d.street(who.street)] if who.street else []
        place += [d.postCode(who.postcode)] if who.postcode else []
        place += [d.city(who.city), d.countryCode(who.country)]
        return [self.text("name", who.name), *reach, d.location(*place)]

    def identification(self, issuer: str, value: str, name: str) -> Any:
        """An identification; `issuer` is one of the schema's words."""
        return self.d.identification(self.d.issuer(issuer), self.d.value(one_line(value)), self.text("name", name))

    def quantity(
        self, value: float, unit: str, U: float | None = None, ref_type: str = "", name: str = "", k: float = COVERAGE
    ) -> Any:
        """One number with its expanded uncertainty, k times the standard one."""
        si, given = self.si, [self.si.value(written(value)), self.si.unit(si_unit(unit))]
        if U is not None and np.isfinite(U):
            given.append(self.expanded(U, k))
        named = [self.text("name", name)] if name else []
        return self.d.quantity(*named, si.real(*given), **_ref_type(ref_type))

    def expanded(self, U: float, k: float = COVERAGE) -> Any:
        """The expanded uncertainty of one number."""
        si = self.si
        uncertainty = (
            si.valueExpandedMU(written(U)),
            si.coverageFactor(written(k)),
            si.coverageProbability(str(PROBABILITY)),
        )
        return si.measurementUncertaintyUnivariate(si.expandedMU(*uncertainty))

    def real_list(self, values: ArrayLike, unit: str, U: ArrayLike | None = None, k: float = COVERAGE) -> Any:
        """Numbers of one unit, and their expanded uncertainties, k times the standard ones, where all are known."""
        si, given = self.si, [self.si.valueXMLList(listed(values)), self.si.unitXMLList(si_unit(unit))]
        if U is not None and np.isfinite(U).all():
            uncertainty = (si.valueExpandedMUXMLList(listed(U)), si.coverageFactorXMLList(written(k)))
            expanded = si.expandedMUXMLList(*uncertainty, si.coverageProbabilityXMLList(str(PROBABILITY)))
            given.append(si.measurementUncertaintyUnivariateXMLList(expanded))
        return si.realListXMLList(*given)

    def joint_list(self, names: Sequence[str], values: ArrayLike, units: Sequence[str], covariance: Any) -> Any:
        """Numbers of several units with their covariance matrix (n, n), column by column.

        The coverage factor is that of their joint region, an ellipsoid: the root of the quantile of chi squared.
        """
        si, n = self.si, len(names)
        columns = [
            si.columnXMLList(
                *(
                    si.covarianceXMLList(si.valueXMLList(written(c)), si.unitXMLList(product(units[i], units[j])))
                    for i, c in enumerate(column)
                )
            )
            for j, column in enumerate(np.asarray(covariance, dtype=float).T)
        ]
        region = si.ellipsoidalRegionMUXMLList(
            si.covarianceMatrixXMLList(*columns),
            si.coverageFactorXMLList(written(np.sqrt(2 * scipy.special.gammaincinv(n / 2, PROBABILITY)))),
            si.coverageProbabilityXMLList(str(PROBABILITY)),
        )
        return si.realListXMLList(
            si.labelXMLList(" ".join(map(one_word, names))),
            si.valueXMLList(listed(values)),
            si.unitXMLList(" ".join(map(si_unit, units))),
            si.measurementUncertaintyMultivariateXMLList(region),
        )

    def result(self, name: str, description: str, *data: Any, ref_type: str = "") -> Any:
        """A dcc:result of quantities or lists."""
        said = [self.text("description", description)] if description else []
        return self.d.result(self.text("name", name), *said, self.d.data(*data), **_ref_type(ref_type))


def listed(values: ArrayLike) -> str:
    """Numbers apart by one space each, which read back the same."""
    return " ".join(written(value) for value in np.asarray(values, dtype=float).ravel())


def written(value: float) -> str:
    """A number that reads back the same."""
    return repr(float(value))


def one_line(text: str) -> str:
    """`text` without doubled, leading and trailing blanks; the schema knows no empty string."""
    return " ".join(text.split()) or "not stated"


def one_word(text: str) -> str:
    """`text` as one item of a list."""
    return "_".join(text.split()) or "-"


def _ref_type(ref_type: str) -> dict[str, str]:
    return {"refType": ref_type} if ref_type else {}
