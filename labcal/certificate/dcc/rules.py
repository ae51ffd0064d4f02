"""What a DCC of a magnetometer has to state beyond its schema, each rule with the clause that asks for it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from labcal.certificate.dcc.parts import DCC, SI

NAMES = {"dcc": DCC, "si": SI}
CORE = "/*/dcc:administrativeData/dcc:coreData"
MEASURED = "/*/dcc:measurementResults/dcc:measurementResult"
RESULTS = f"{MEASURED}/dcc:results/dcc:result"
INDICATIONS = f"{RESULTS}[@refType='basic_result']/dcc:data/dcc:list"
JUDGED = f"{RESULTS}/dcc:data/dcc:quantity/dcc:measurementMetaData/dcc:metaData[dcc:conformity]"
U_OF_ONE = "si:real/si:measurementUncertaintyUnivariate/si:expandedMU"
U_OF_LIST = "si:realListXMLList/si:measurementUncertaintyUnivariateXMLList/si:expandedMUXMLList"


@dataclass(frozen=True, slots=True)
class Rule:
    """Every node that `each` finds has to have one that `has` finds, and `each` has to find one unless `optional`."""

    clause: str
    says: str
    each: str
    has: str
    optional: bool = False


RULES = (
    Rule("ISO/IEC 17025:2017, 7.8.2.1 b", "name of the laboratory", "/*/dcc:administrativeData",
         "dcc:calibrationLaboratory/dcc:contact/dcc:name/dcc:content[normalize-space()]"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 b", "address of the laboratory", "/*/dcc:administrativeData",
         "dcc:calibrationLaboratory/dcc:contact/dcc:location/dcc:city"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 c", "place of the measurement", CORE, "dcc:performanceLocation"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 d", "unique number", CORE, "dcc:uniqueIdentifier[normalize-space()]"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 e", "customer", "/*/dcc:administrativeData",
         "dcc:customer/dcc:name/dcc:content[normalize-space()]"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 f", "method", MEASURED, "dcc:usedMethods/dcc:usedMethod/dcc:name"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 g", "serial number of the item", "/*/dcc:administrativeData/dcc:items/dcc:item",
         "dcc:identifications/dcc:identification/dcc:value[normalize-space()]"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 g", "condition of the item", "/*/dcc:administrativeData/dcc:items/dcc:item",
         "dcc:description/dcc:content[starts-with(., 'Condition')]"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 i", "dates of the calibration", CORE, "dcc:beginPerformanceDate"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 i", "dates of the calibration", CORE, "dcc:endPerformanceDate"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 j", "date of issue", CORE, "dcc:issueDate"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 l", "results relate only to the item", "/*/dcc:administrativeData/dcc:statements",
         "dcc:statement/dcc:declaration/dcc:content[contains(., 'relate only to the item')]"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 m", "unit of every result", f"{RESULTS}//si:real", "si:unit[normalize-space()]",
         optional=True),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 m", "unit of every result", f"{RESULTS}//si:realListXMLList",
         "si:unitXMLList[normalize-space()]"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 o", "who authorised it", "/*/dcc:administrativeData/dcc:respPersons",
         "dcc:respPerson[dcc:mainSigner = 'true']/dcc:person/dcc:name"),
    Rule("ISO/IEC 17025:2017, 7.8.2.1 o", "who measured it", "/*/dcc:administrativeData/dcc:respPersons",
         "dcc:respPerson[dcc:role = 'operator']/dcc:person/dcc:name"),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 a", "uncertainty of K and k",
         f"{RESULTS}[@refType='labcal_K' or @refType='labcal_k']", f"dcc:data/dcc:quantity/{U_OF_LIST}"),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 a", "uncertainty of every effect", f"{RESULTS}[@refType='labcal_effect']//"
         "dcc:quantity[@refType='labcal_effectParameter']", U_OF_ONE, optional=True),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 a", "uncertainty of every error of indication",
         f"{INDICATIONS}/dcc:quantity[@refType='basic_measurementError']", U_OF_LIST),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 a", "covariance of the parameters", f"{MEASURED}/dcc:results",
         "dcc:result[@refType='labcal_covariance']//si:covarianceMatrixXMLList"),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 a", "budget", f"{MEASURED}/dcc:results", "dcc:result[@refType='labcal_budget']"),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 b", "conditions of the measurement", f"{MEASURED}/dcc:influenceConditions",
         "dcc:influenceCondition/dcc:data/dcc:quantity/si:real"),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 c", "traceability of the reference", f"{MEASURED}/dcc:measuringEquipments",
         "dcc:measuringEquipment[@refType='basic_referenceStandard']/dcc:description/"
         "dcc:content[contains(., 'traceab')]"),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 c", "serial number of the reference",
         f"{MEASURED}/dcc:measuringEquipments/dcc:measuringEquipment[@refType='basic_referenceStandard']",
         "dcc:identifications/dcc:identification[dcc:name/dcc:content = 'serial number']"),
    Rule("ISO/IEC 17025:2017, 7.8.4.1 c", "certificate of the reference",
         f"{MEASURED}/dcc:measuringEquipments/dcc:measuringEquipment[@refType='basic_referenceStandard']",
         "dcc:identifications/dcc:identification[dcc:name/dcc:content = 'number of its certificate']"),
    Rule("ISO/IEC 17025:2017, 7.8.6.2 a", "what each statement of conformity is about",
         f"{RESULTS}[@refType='labcal_specification']", "dcc:name/dcc:content[normalize-space()]", optional=True),
    Rule("ISO/IEC 17025:2017, 7.8.6.2 b", "specification of each statement", JUDGED,
         "dcc:name/dcc:content[contains(., 'specification')]", optional=True),
    Rule("ISO/IEC 17025:2017, 7.8.6.2 b", "limit of each statement", JUDGED,
         "dcc:data/dcc:quantity[@refType='basic_acceptanceLimit']/si:real", optional=True),
    Rule("ISO/IEC 17025:2017, 7.8.6.2 c", "decision rule of each statement",
         JUDGED,
         "dcc:declaration/dcc:content[contains(., 'Decision rule')]", optional=True),
    Rule("ILAC G8:09/2019", "verdict of each statement", f"{RESULTS}[@refType='labcal_specification']",
         ".//dcc:metaData/dcc:conformity", optional=True),
    Rule("ILAC G8:09/2019", "guide that the rule is from", JUDGED,
         "dcc:norm[contains(., 'G8')]", optional=True),
    Rule("ISO/IEC 17025:2017, 7.8.6.1", "value and uncertainty that were judged",
         f"{RESULTS}[@refType='labcal_specification']", f"dcc:data/dcc:quantity/{U_OF_ONE}", optional=True),
    Rule("ILAC P14:09/2020, 5", "coverage factor of every uncertainty", f"{RESULTS}//si:expandedMU",
         "si:coverageFactor", optional=True),
    Rule("ILAC P14:09/2020, 5", "coverage factor of every uncertainty", f"{RESULTS}//si:expandedMUXMLList",
         "si:coverageFactorXMLList"),
    Rule("ILAC P14:09/2020, 5", "coverage probability of every uncertainty", f"{RESULTS}//si:expandedMU",
         "si:coverageProbability", optional=True),
    Rule("ILAC P14:09/2020, 5", "coverage probability of every uncertainty", f"{RESULTS}//si:expandedMUXMLList",
         "si:coverageProbabilityXMLList"),
    Rule("ILAC P14:09/2020, 5", "how the uncertainty was worked out", f"{MEASURED}/dcc:usedMethods",
         "dcc:usedMethod/dcc:norm[contains(., 'JCGM 100')]"),
)  # fmt: skip


def objections(root: Any) -> tuple[str, ...]:
    """What the certificate `root` (an lxml element) lacks, a clause and what it asks for each; empty where nothing."""
    return tuple(dict.fromkeys(f"{rule.clause}: {rule.says}" for rule in RULES if not _kept(rule, root)))


def lacks(xml: bytes) -> tuple[str, ...]:
    """The same of the certificate whose bytes are `xml`."""
    from lxml import etree

    return objections(etree.fromstring(xml))


def _kept(rule: Rule, root: Any) -> bool:
    found, has = _path(rule.each)(root), _path(rule.has)
    return bool(found or rule.optional) and all(map(has, found))


@cache
def _path(text: str) -> Any:
    """A path, compiled once."""
    from lxml import etree

    return etree.XPath(text, namespaces=NAMES)
