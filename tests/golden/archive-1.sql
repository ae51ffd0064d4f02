--
-- PostgreSQL database dump
--

\restrict zSz7wAXuR2CAaYz4cr1oFCOJNquDo6wh4iRZ71jv290g79N0LTJ7YajlQ7hmsoS

-- Dumped from database version 15.18 (Debian 15.18-0+deb12u1)
-- Dumped by pg_dump version 15.18 (Debian 15.18-0+deb12u1)

SET statement_timeout = 0;
SET lock_timeout = 0;
SET idle_in_transaction_session_timeout = 0;
SET client_encoding = 'UTF8';
SET standard_conforming_strings = on;
SELECT pg_catalog.set_config('search_path', '', false);
SET check_function_bodies = false;
SET xmloption = content;
SET client_min_messages = warning;
SET row_security = off;

--
-- Name: labcal; Type: SCHEMA; Schema: -; Owner: -
--

CREATE SCHEMA labcal;


--
-- Name: labs(text[]); Type: FUNCTION; Schema: labcal; Owner: -
--

CREATE FUNCTION labcal.labs(wanted text[]) RETURNS text[]
    LANGUAGE sql STABLE
    SET search_path TO 'pg_catalog'
    AS $$
    SELECT coalesce(array_agg(m.lab), '{}') FROM labcal.member m JOIN pg_roles r ON r.rolname = m.role
    WHERE m.duty = ANY (wanted) AND pg_has_role(r.oid, 'MEMBER') $$;


SET default_tablespace = '';

SET default_table_access_method = heap;

--
-- Name: alembic_version; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.alembic_version (
    version_num character varying(32) NOT NULL
);


--
-- Name: audit; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.audit (
    site text NOT NULL,
    log text NOT NULL,
    link text NOT NULL,
    number bigint NOT NULL,
    utc text NOT NULL,
    deed text NOT NULL,
    who text NOT NULL,
    machine text NOT NULL,
    entry bytea NOT NULL,
    signature bytea NOT NULL
);


--
-- Name: calibration; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.calibration (
    site text NOT NULL,
    sha256 text NOT NULL,
    run_sha256 text NOT NULL,
    run_id text NOT NULL,
    simulated boolean NOT NULL,
    dut_serial text NOT NULL,
    dut_model text NOT NULL,
    dut_unit text NOT NULL,
    operator text NOT NULL,
    issued_utc timestamp with time zone,
    number text,
    supersedes text,
    content bytea NOT NULL,
    pushed_utc timestamp with time zone DEFAULT now() NOT NULL,
    pushed_by text DEFAULT CURRENT_USER NOT NULL
);


--
-- Name: document; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.document (
    site text NOT NULL,
    of text NOT NULL,
    sha256 text NOT NULL,
    kind text NOT NULL,
    name text NOT NULL,
    signer text NOT NULL,
    objection text NOT NULL,
    content bytea NOT NULL
);


--
-- Name: effect; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.effect (
    site text NOT NULL,
    calibration text NOT NULL,
    number integer NOT NULL,
    effect text NOT NULL,
    belongs_to text NOT NULL,
    channels text NOT NULL,
    provisional boolean NOT NULL,
    p_value double precision
);


--
-- Name: instrument; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.instrument (
    site text NOT NULL,
    of text NOT NULL,
    number integer NOT NULL,
    name text NOT NULL,
    manufacturer text NOT NULL,
    model text NOT NULL,
    serial text NOT NULL,
    firmware text NOT NULL
);


--
-- Name: kept_head; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.kept_head (
    site text NOT NULL,
    head text NOT NULL,
    sha256 text NOT NULL
);


--
-- Name: member; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.member (
    role text NOT NULL,
    lab text NOT NULL,
    duty text NOT NULL
);


--
-- Name: parameter; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.parameter (
    site text NOT NULL,
    calibration text NOT NULL,
    number integer NOT NULL,
    of text NOT NULL,
    name text NOT NULL,
    value double precision NOT NULL,
    u double precision,
    unit text NOT NULL
);


--
-- Name: run; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.run (
    site text NOT NULL,
    sha256 text NOT NULL,
    run_id text NOT NULL,
    started_utc timestamp with time zone NOT NULL,
    status text NOT NULL,
    simulated boolean NOT NULL,
    dut_serial text NOT NULL,
    dut_model text NOT NULL,
    dut_unit text NOT NULL,
    operator text NOT NULL,
    procedure text NOT NULL,
    reference_kind text NOT NULL,
    reference_serial text NOT NULL,
    n_samples bigint NOT NULL,
    chain_head text,
    bundle_sha256 text NOT NULL,
    bundle_bytes bigint NOT NULL,
    pushed_utc timestamp with time zone DEFAULT now() NOT NULL,
    pushed_by text DEFAULT CURRENT_USER NOT NULL
);


--
-- Name: setting; Type: TABLE; Schema: labcal; Owner: -
--

CREATE TABLE labcal.setting (
    name text NOT NULL,
    value text NOT NULL
);


--
-- Data for Name: alembic_version; Type: TABLE DATA; Schema: labcal; Owner: -
--

INSERT INTO labcal.alembic_version VALUES ('0001');


--
-- Data for Name: audit; Type: TABLE DATA; Schema: labcal; Owner: -
--



--
-- Data for Name: calibration; Type: TABLE DATA; Schema: labcal; Owner: -
--

INSERT INTO labcal.calibration VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 'abababababababababababababababababababababababababababababababab', 'r-2026-11-21-01', true, 'FM-07', 'flight model', 'count of 0.5 nT', 'Grace Häberli', NULL, NULL, NULL, '\x7b224b223a5b5b302e352c302e3030312c305d2c5b302c302e35312c305d2c5b302c302e3030322c302e34395d5d2c22617070726f76657273223a5b5d2c22627564676574223a5b5d2c22636167655f736861323536223a6e756c6c2c22636861696e223a6e756c6c2c22636f76617269616e6365223a5b5b31652d31302c302c302c302c302c302c302c302c302c302c302c302c302c302c305d2c5b302c31652d31302c302c302c302c302c302c302c302c302c302c302c302c302c305d2c5b302c302c31652d31302c302c302c302c302c302c302c302c302c302c302c302c305d2c5b302c302c302c31652d31302c302c302c302c302c302c302c302c302c302c302c305d2c5b302c302c302c302c31652d31302c302c302c302c302c302c302c302c302c302c305d2c5b302c302c302c302c302c31652d31302c302c302c302c302c302c302c302c302c305d2c5b302c302c302c302c302c302c31652d31302c302c302c302c302c302c302c302c305d2c5b302c302c302c302c302c302c302c31652d31302c302c302c302c302c302c302c305d2c5b302c302c302c302c302c302c302c302c31652d31302c302c302c302c302c302c305d2c5b302c302c302c302c302c302c302c302c302c342c302c302c302e3533362c302c305d2c5b302c302c302c302c302c302c302c302c302c302c342c302c302c302e3533362c305d2c5b302c302c302c302c302c302c302c302c302c302c302c342c302c302c302e3533365d2c5b302c302c302c302c302c302c302c302c302c302e3533362c302c302c302e31362c302c305d2c5b302c302c302c302c302c302c302c302c302c302c302e3533362c302c302c302e31362c305d2c5b302c302c302c302c302c302c302c302c302c302c302c302e3533362c302c302c302e31365d5d2c22636f76617269616e63655f6f66223a5b224b5f7878222c224b5f7879222c224b5f787a222c224b5f7978222c224b5f7979222c224b5f797a222c224b5f7a78222c224b5f7a79222c224b5f7a7a222c226b5f78222c226b5f79222c226b5f7a222c22303a635f78222c22303a635f79222c22303a635f7a225d2c22647574223a7b226d6f64656c223a22666c69676874206d6f64656c222c226e6f6d696e616c5f6e545f7065725f756e6974223a302e352c2273657269616c223a22464d2d3037222c22756e6974223a22636f756e74227d2c2265666665637473223a5b7b2262656c6f6e67735f746f223a2273656e736f72222c226368616e6e656c73223a5b22695f657073225d2c22656666656374223a226f66667365742d63757272656e74222c22686f6c646f75745f726d735f61667465725f6e54223a34332e37352c22686f6c646f75745f726d735f6265666f72655f6e54223a38382e352c22696d70726f76656d656e745f636939355f6e54223a5b33382c35312e355d2c22705f76616c7565223a31652d392c22706172616d6574657273223a5b7b226e616d65223a22635f78222c2275223a302e342c22756e6974223a226e542f41222c2276616c7565223a3131322e357d2c7b226e616d65223a22635f79222c2275223a302e342c22756e6974223a226e542f41222c2276616c7565223a2d34302e32357d2c7b226e616d65223a22635f7a222c2275223a302e342c22756e6974223a226e542f41222c2276616c7565223a337d5d2c2270726f766973696f6e616c223a66616c73652c227265666572656e63655f76616c7565223a7b22695f657073223a302e32357d2c22726976616c73223a5b7b226368616e6e656c73223a5b2274656d705f647574225d2c22656666656374223a226f66667365742d74656d7065726174757265222c22686f6c646f75745f726d735f61667465725f6e54223a37317d5d2c22776879223a22546865206f666673657420666f6c6c6f7773207468652063757272656e74206f662074686520706f77657220737570706c792e227d5d2c2266696e64696e6773223a5b7b2262656c6f6e67735f746f223a22726967222c226368616e6e656c73223a5b5d2c22656666656374223a22617869732d74696c74222c22686f6c646f75745f726d735f61667465725f6e54223a6e756c6c2c22686f6c646f75745f726d735f6265666f72655f6e54223a6e756c6c2c22696d70726f76656d656e745f636939355f6e54223a6e756c6c2c22705f76616c7565223a6e756c6c2c22706172616d6574657273223a5b7b226e616d65223a22636167655f78222c2275223a302e30322c22756e6974223a22646567222c2276616c7565223a302e33357d5d2c2270726f766973696f6e616c223a747275652c227265666572656e63655f76616c7565223a7b7d2c22726976616c73223a5b5d2c22776879223a2254686520706c6174666f726d2061786973206c65616e7320746f7761726473206361676520782e227d5d2c22666f726d6174223a226c616263616c2d63616c6962726174696f6e2f32222c226672616d655f6b6e6f776e223a747275652c22696e737472756d656e7473223a5b7b226d6f64656c223a22484d5232333030222c22726f6c65223a227265666572656e6365222c2273657269616c223a22482d31227d5d2c226973737565645f757463223a6e756c6c2c226b5f6174223a7b22695f657073223a302e32357d2c226b5f6e54223a5b3132302c2d382c335d2c226d6164655f6279223a6e756c6c2c226d657472696373223a7b226166746572223a7b22686f6c646f75745f726d735f6e54223a34332e37357d2c226265666f7265223a7b22686f6c646f75745f726d735f6e54223a38382e352c22747261696e5f726d735f6e54223a38387d7d2c226e6f745f636f7665726564223a5b22416765696e672e225d2c226e756d626572223a6e756c6c2c226f70657261746f72223a2247726163652048c3a46265726c69222c2272756e5f6964223a22722d323032362d31312d32312d3031222c2272756e5f736861323536223a2261626162616261626162616261626162616261626162616261626162616261626162616261626162616261626162616261626162616261626162616261626162222c2273696d756c61746564223a747275652c22736f667477617265223a226c616263616c20302e312e30222c227370616e5f73223a5b302c323730305d2c2273706563696669636174696f6e223a5b5d2c2273757065727365646573223a6e756c6c2c2276616c6964697479223a7b226669656c645f6e54223a5b32303030302c36303030305d2c226d6f646573223a5b226e6f6d696e616c222c2273616665225d2c2274656d70657261747572655f43223a5b31382e352c32345d2c22756e74696c223a22323032372d31312d3231227d7d', '2026-11-23 04:57:16.720417+00', 'labcal');


--
-- Data for Name: document; Type: TABLE DATA; Schema: labcal; Owner: -
--

INSERT INTO labcal.document VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', '89ef4c859b22aba0d2f4232478b140df91a466d6e17aacfb54b2deaa198b26b2', 'signature', 'cal.json.sshsig', '', 'is not a whole SSH signature: its text is damaged', '\x2d2d2d2d2d424547494e20535348205349474e41545552452d2d2d2d2d0a6e6f206f6e6527730a2d2d2d2d2d454e4420535348205349474e41545552452d2d2d2d2d0a');


--
-- Data for Name: effect; Type: TABLE DATA; Schema: labcal; Owner: -
--

INSERT INTO labcal.effect VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 0, 'offset-current', 'sensor', 'i_eps', false, 1e-09);
INSERT INTO labcal.effect VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 1, 'axis-tilt', 'rig', '', true, NULL);


--
-- Data for Name: instrument; Type: TABLE DATA; Schema: labcal; Owner: -
--

INSERT INTO labcal.instrument VALUES ('aalto', '6491cf648b558c822bde96ca3bea126f437fb18659685fe8c662f55a4b191055', 0, 'reference', '', '', 'R7', '');
INSERT INTO labcal.instrument VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 0, 'reference', '', 'HMR2300', 'H-1', '');
INSERT INTO labcal.instrument VALUES ('glasgow', '73a19c4e4e405196fea521d01c5b23a5b2b019a0f29edb74fe9ef1427e320141', 0, 'reference', '', '', 'R7', '');


--
-- Data for Name: kept_head; Type: TABLE DATA; Schema: labcal; Owner: -
--



--
-- Data for Name: member; Type: TABLE DATA; Schema: labcal; Owner: -
--



--
-- Data for Name: parameter; Type: TABLE DATA; Schema: labcal; Owner: -
--

INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 0, 'map', 'K_xx', 0.5, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 1, 'map', 'K_xy', 0.001, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 2, 'map', 'K_xz', 0, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 3, 'map', 'K_yx', 0, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 4, 'map', 'K_yy', 0.51, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 5, 'map', 'K_yz', 0, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 6, 'map', 'K_zx', 0, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 7, 'map', 'K_zy', 0.002, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 8, 'map', 'K_zz', 0.49, 1e-05, 'nT/count');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 9, 'map', 'k_x', 120, 2, 'nT');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 10, 'map', 'k_y', -8, 2, 'nT');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 11, 'map', 'k_z', 3, 2, 'nT');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 12, 'figure', 'offset x', 120.0156862745098, 2.0000052921585514, 'nT');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 13, 'figure', 'offset y', -7.8431372549019605, 1.9607857328277096, 'nT');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 14, 'figure', 'offset z', 3.093237294917967, 2.040833496057928, 'nT');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 15, 'figure', 'scale x', -1.9223320194550197, 20.00003695473753, 'ppm');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 16, 'figure', 'scale y', 20000.00000000002, 20.000206596537986, 'ppm');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 17, 'figure', 'scale z', -20007.53547633061, 20.000141958681475, 'ppm');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 18, 'figure', 'non-orthogonality x-y', -0.112344521736011, 0.001604765124753149, 'deg');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 19, 'figure', 'non-orthogonality y-z', -0.2246881796245023, 0.0016215376391168765, 'deg');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 20, 'figure', 'non-orthogonality z-x', 0.0004405630819742193, 0.0016372046793291979, 'deg');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 21, 'offset-current', 'c_x', 112.5, 0.4, 'nT/A');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 22, 'offset-current', 'c_y', -40.25, 0.4, 'nT/A');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 23, 'offset-current', 'c_z', 3, 0.4, 'nT/A');
INSERT INTO labcal.parameter VALUES ('aalto', '8a8654266df4e99c9f125482aff89d63ac7406498b24e378b88c04c12340d596', 24, 'axis-tilt', 'cage_x', 0.35, 0.02, 'deg');


--
-- Data for Name: run; Type: TABLE DATA; Schema: labcal; Owner: -
--

INSERT INTO labcal.run VALUES ('aalto', '6491cf648b558c822bde96ca3bea126f437fb18659685fe8c662f55a4b191055', 'demo-0', '2026-03-02 08:15:00+00', 'imported', true, 'SN-1', 'M3', 'nT', 'bench', '', 'vector', 'R7', 3, NULL, 'f53c6e7d8dad751befc09b1a208705c620affd5282038e8db7a6c1f928f9a6de', 704, '2026-11-23 04:57:16.466814+00', 'labcal');
INSERT INTO labcal.run VALUES ('glasgow', '73a19c4e4e405196fea521d01c5b23a5b2b019a0f29edb74fe9ef1427e320141', 'demo-0', '2026-03-02 08:15:00+00', 'imported', true, 'SN-2', 'M3', 'nT', 'bench', '', 'vector', 'R7', 3, NULL, '5e45acc13fed26eaaa7f545a072b9953504a93c74ecdd52e2f547ff8ab140f44', 704, '2026-11-23 04:57:17.131853+00', 'labcal');


--
-- Data for Name: setting; Type: TABLE DATA; Schema: labcal; Owner: -
--



--
-- Name: alembic_version alembic_version_pkc; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.alembic_version
    ADD CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num);


--
-- Name: audit audit_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.audit
    ADD CONSTRAINT audit_pkey PRIMARY KEY (site, log, link);


--
-- Name: calibration calibration_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.calibration
    ADD CONSTRAINT calibration_pkey PRIMARY KEY (site, sha256);


--
-- Name: document document_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.document
    ADD CONSTRAINT document_pkey PRIMARY KEY (site, of, sha256);


--
-- Name: effect effect_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.effect
    ADD CONSTRAINT effect_pkey PRIMARY KEY (site, calibration, number);


--
-- Name: instrument instrument_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.instrument
    ADD CONSTRAINT instrument_pkey PRIMARY KEY (site, of, number);


--
-- Name: kept_head kept_head_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.kept_head
    ADD CONSTRAINT kept_head_pkey PRIMARY KEY (site, head);


--
-- Name: member member_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.member
    ADD CONSTRAINT member_pkey PRIMARY KEY (role, lab, duty);


--
-- Name: parameter parameter_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.parameter
    ADD CONSTRAINT parameter_pkey PRIMARY KEY (site, calibration, number);


--
-- Name: run run_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.run
    ADD CONSTRAINT run_pkey PRIMARY KEY (site, sha256);


--
-- Name: setting setting_pkey; Type: CONSTRAINT; Schema: labcal; Owner: -
--

ALTER TABLE ONLY labcal.setting
    ADD CONSTRAINT setting_pkey PRIMARY KEY (name);


--
-- Name: calibration_dut; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX calibration_dut ON labcal.calibration USING btree (dut_serial, dut_model);


--
-- Name: calibration_run; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX calibration_run ON labcal.calibration USING btree (run_sha256);


--
-- Name: calibration_supersedes; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX calibration_supersedes ON labcal.calibration USING btree (supersedes);


--
-- Name: effect_named; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX effect_named ON labcal.effect USING btree (effect);


--
-- Name: instrument_serial; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX instrument_serial ON labcal.instrument USING btree (serial);


--
-- Name: parameter_named; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX parameter_named ON labcal.parameter USING btree (calibration, of, name);


--
-- Name: parameter_of; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX parameter_of ON labcal.parameter USING btree (of, unit);


--
-- Name: run_content; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX run_content ON labcal.run USING btree (sha256);


--
-- Name: run_named; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX run_named ON labcal.run USING btree (run_id);


--
-- Name: run_started; Type: INDEX; Schema: labcal; Owner: -
--

CREATE INDEX run_started ON labcal.run USING btree (started_utc);


--
-- Name: audit added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.audit FOR INSERT WITH CHECK ((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])));


--
-- Name: calibration added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.calibration FOR INSERT WITH CHECK (((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])) AND (pushed_by = CURRENT_USER)));


--
-- Name: document added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.document FOR INSERT WITH CHECK ((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])));


--
-- Name: effect added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.effect FOR INSERT WITH CHECK ((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])));


--
-- Name: instrument added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.instrument FOR INSERT WITH CHECK ((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])));


--
-- Name: kept_head added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.kept_head FOR INSERT WITH CHECK ((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])));


--
-- Name: parameter added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.parameter FOR INSERT WITH CHECK ((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])));


--
-- Name: run added; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY added ON labcal.run FOR INSERT WITH CHECK (((site = ANY (( SELECT labcal.labs('{push}'::text[]) AS labs)::text[])) AND (pushed_by = CURRENT_USER)));


--
-- Name: audit; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.audit ENABLE ROW LEVEL SECURITY;

--
-- Name: calibration; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.calibration ENABLE ROW LEVEL SECURITY;

--
-- Name: document; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.document ENABLE ROW LEVEL SECURITY;

--
-- Name: effect; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.effect ENABLE ROW LEVEL SECURITY;

--
-- Name: instrument; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.instrument ENABLE ROW LEVEL SECURITY;

--
-- Name: kept_head; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.kept_head ENABLE ROW LEVEL SECURITY;

--
-- Name: parameter; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.parameter ENABLE ROW LEVEL SECURITY;

--
-- Name: run; Type: ROW SECURITY; Schema: labcal; Owner: -
--

ALTER TABLE labcal.run ENABLE ROW LEVEL SECURITY;

--
-- Name: audit seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.audit FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- Name: calibration seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.calibration FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- Name: document seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.document FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- Name: effect seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.effect FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- Name: instrument seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.instrument FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- Name: kept_head seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.kept_head FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- Name: parameter seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.parameter FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- Name: run seen; Type: POLICY; Schema: labcal; Owner: -
--

CREATE POLICY seen ON labcal.run FOR SELECT USING (((site = ANY (( SELECT labcal.labs('{read,push}'::text[]) AS labs)::text[])) OR (( SELECT labcal.labs('{read}'::text[]) AS labs) && '{*}'::text[])));


--
-- PostgreSQL database dump complete
--

\unrestrict zSz7wAXuR2CAaYz4cr1oFCOJNquDo6wh4iRZ71jv290g79N0LTJ7YajlQ7hmsoS


