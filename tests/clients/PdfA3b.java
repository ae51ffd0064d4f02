import java.io.FileInputStream;
import java.util.ArrayList;
import java.util.Date;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.xml.parsers.DocumentBuilderFactory;
import org.verapdf.gf.foundry.VeraGreenfieldFoundryProvider;
import org.verapdf.pdfa.Foundries;
import org.verapdf.pdfa.PDFAParser;
import org.verapdf.pdfa.PDFAValidator;
import org.verapdf.pdfa.flavours.PDFAFlavour;
import org.verapdf.pdfa.results.TestAssertion;
import org.verapdf.pdfa.results.ValidationResult;
import org.verapdf.pdfa.validation.profiles.ErrorArgument;
import org.verapdf.pdfa.validation.profiles.Profiles;
import org.verapdf.pdfa.validation.profiles.Rule;
import org.verapdf.pdfa.validation.profiles.ValidationProfile;
import org.verapdf.pdfa.validation.profiles.Variable;
import org.verapdf.pdfa.validation.validators.ValidatorFactory;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * Files held against veraPDF's profile of PDF/A-3b, a line a file: its name, rules asked, assertions made, the rules that failed.
 *
 * The profile is read here, as veraPDF's own reader needs a JAXB that does not come with it.
 */
public class PdfA3b {
    static final String PROFILE = "/org/verapdf/pdfa/validation/PDFA-3B.xml";
    static final int MOST_FAILURES = 1000; // of one rule; the first is all that is printed of it

    public static void main(String[] files) throws Exception {
        VeraGreenfieldFoundryProvider.initialise();
        ValidationProfile profile = profile();
        for (String file : files) {
            try (PDFAParser pdf = Foundries.defaultInstance().createParser(new FileInputStream(file), PDFAFlavour.PDFA_3_B);
                 PDFAValidator asked = ValidatorFactory.createValidator(profile, MOST_FAILURES, false, false, false)) {
                ValidationResult found = asked.validate(pdf);
                System.out.println(String.join("\t", file, "" + profile.getRules().size(), "" + found.getTotalAssertions(),
                    String.join(" ", failed(found))));
            }
        }
    }

    static Set<String> failed(ValidationResult found) {
        Set<String> rules = new HashSet<>();
        for (TestAssertion one : found.getTestAssertions()) {
            if (one.getStatus() == TestAssertion.Status.FAILED) {
                rules.add(one.getRuleId().getClause() + "-" + one.getRuleId().getTestNumber());
            }
        }
        if (rules.isEmpty() != found.isCompliant()) {
            throw new IllegalStateException("what failed and what is said of it differ");
        }
        return rules;
    }

    static ValidationProfile profile() throws Exception {
        Document xml = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(PdfA3b.class.getResourceAsStream(PROFILE));
        Set<Rule> rules = new HashSet<>();
        for (Element one : within(xml.getDocumentElement(), "rule")) {
            rules.add(rule(one));
        }
        Set<Variable> variables = new HashSet<>();
        for (Element one : within(xml.getDocumentElement(), "variable")) {
            variables.add(Profiles.variableFromValues(
                one.getAttribute("name"), one.getAttribute("object"), text(one, "defaultValue"), text(one, "value")));
        }
        return Profiles.profileFromValues(
            PDFAFlavour.PDFA_3_B, Profiles.profileDetailsFromValues("PDF/A-3b", "", "", new Date()), "", rules, variables);
    }

    static Rule rule(Element one) {
        Element id = within(one, "id").get(0);
        return Profiles.ruleFromValues(
            Profiles.ruleIdFromValues(PDFAFlavour.Specification.valueOf(id.getAttribute("specification")),
                id.getAttribute("clause"), Integer.parseInt(id.getAttribute("testNumber"))),
            one.getAttribute("object"), "true".equals(one.getAttribute("deferred")), null, text(one, "description"),
            text(one, "test"), Profiles.errorFromValues(text(one, "message"), new ArrayList<ErrorArgument>()), new ArrayList<>());
    }

    static List<Element> within(Element parent, String name) {
        List<Element> found = new ArrayList<>();
        NodeList all = parent.getElementsByTagName(name);
        for (int i = 0; i < all.getLength(); i++) {
            found.add((Element) all.item(i));
        }
        return found;
    }

    static String text(Element parent, String name) {
        return within(parent, name).get(0).getTextContent();
    }
}
