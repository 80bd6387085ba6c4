// Draws the states of a plan from above, for the extension "PDDL" of Visual Studio Code. Written by neurosym;
// do not edit: compile-domain and new-problem write it again, with the scenes of all problems of the folder.
// Below stands the robot, x leads away from it, and y to its left.
module.exports = (function (data) {
    "use strict";
    const MARGIN = 0.03, NOTES = new Set(["look-on", "reach-place", "leave-start", "reach-goal"]);
    const LATER = /^(finish-.*|move-[xyz])$/;
    const COLOURS = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#997700", "#555555"];

    /** Returns text as HTML. */
    function escaped(text) {
        return String(text).replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");
    }

    /** Returns the scene of a plan's problem, or null. */
    function sceneOf(plan) {
        const name = plan && plan.problem && plan.problem.name;
        return name && Object.hasOwn(data.problems, name) ? data.problems[name] : null;
    }

    /** Returns where every object stands: as the scene says, then as facts do, in any order. */
    function stateOf(scene, facts) {
        const state = {};
        for (const name of Object.keys(scene.objects)) {
            state[name] = { at: scene.objects[name].at.slice(), z: 0 };
        }
        for (const led of [false, true]) { // cells say more than the place where something started
            for (const fact of facts) {
                const words = fact.variableName.toLowerCase().split(" ");
                if (fact.value === false || words.length !== 3 || !state[words[1]]) { continue; }
                if (!led && words[0] === "stands") { moveToPlace(state, scene, words[1], words[2]); }
                if (led && /^at-[xyz]$/.test(words[0])) { moveToCell(state, scene, words[1], words[2]); }
            }
        }
        return state;
    }

    /** Returns where a place lies, or null: names of spots say so themselves, in tenths of a millimetre. */
    function placeNamed(scene, place) {
        const spot = /^spot-(m?\d+)-(m?\d+)$/.exec(place);
        if (Object.hasOwn(scene.places, place)) { return scene.places[place].slice(); }
        return spot && spot.slice(1).map(word => Number(word.replace("m", "-")) / 10000);
    }

    function moveToPlace(state, scene, name, place) {
        const at = placeNamed(scene, place);
        if (at) { state[name] = { at: at, z: 0 }; }
        return at !== null;
    }

    /** Moves an object along an axis, as far from where it started as its cell is from the one it started in. */
    function moveToCell(state, scene, name, cell) {
        const axis = "xyz".indexOf(cell[0]), index = Number(cell.slice(1));
        if (axis === 2) {
            state[name].z = index;
        } else {
            const object = scene.objects[name];
            state[name].at[axis] = object.at[axis] + (index - object.cell[axis]) * data.cell;
        }
    }

    /** Does a step of a plan; returns what to write below the picture, or "" if it belongs to the step before. */
    function act(state, scene, words) {
        const name = words.slice(1).find(word => Object.hasOwn(scene.objects, word));
        if (name === undefined || NOTES.has(words[0])) { return ""; }
        const after = words.slice(words.indexOf(name) + 1);
        for (const place of [after[1], after[0]]) { // from one place to another, or only where to
            if (place !== undefined && moveToPlace(state, scene, name, place)) {
                return [words[0], name, place].join(" ");
            }
        }
        for (const word of words) {
            if (/^[xyz]\d+$/.test(word)) { moveToCell(state, scene, name, word); }
        }
        return LATER.test(words[0]) ? "" : words[0] + " " + name;
    }

    /** Returns the states of a plan, with what led to each. */
    function framesOf(plan, scene) {
        const inits = plan.problem.getInits ? plan.problem.getInits() : plan.problem.inits || [];
        const state = stateOf(scene, inits);
        const frames = [{ said: "start", state: copied(state) }];
        for (const step of plan.steps) {
            const said = act(state, scene, step.fullActionName.toLowerCase().split(" "));
            const frame = { said: said || frames[frames.length - 1].said, state: copied(state) };
            if (said) { frames.push(frame); } else { frames[frames.length - 1] = frame; }
        }
        return frames;
    }

    function copied(state) {
        return JSON.parse(JSON.stringify(state));
    }

    /** Returns the picture of a state, some pixels wide. */
    function drawn(scene, state, width) {
        const [left, right] = [data.table.y[1] + MARGIN, data.table.y[0] - MARGIN];
        const [far, near] = [data.table.x[1] + MARGIN, data.table.x[0] - MARGIN];
        const scale = width / (left - right), height = (far - near) * scale;
        const across = y => (left - y) * scale, down = x => (far - x) * scale;
        const number = value => (Math.round(10 * value) / 10).toString();
        const box = (at, size, looks) => `<rect x="${number(across(at[1]) - size[1] * scale / 2)}" ` +
            `y="${number(down(at[0]) - size[0] * scale / 2)}" width="${number(size[1] * scale)}" ` +
            `height="${number(size[0] * scale)}" ${looks}/>`;
        const words = (at, text, looks) => `<text x="${number(across(at[1]))}" y="${number(down(at[0]))}" ` +
            `text-anchor="middle" dominant-baseline="central" font-size="${number(width / 30)}" ${looks}>` +
            `${escaped(text)}</text>`;
        const table = [data.table.x[1] - data.table.x[0], data.table.y[1] - data.table.y[0]];
        const middle = [data.table.x[0] + table[0] / 2, data.table.y[0] + table[1] / 2];
        const parts = [`<rect width="${number(width)}" height="${number(height)}" fill="#ffffff"/>`,
            box(middle, table, `class="table" fill="#f4efe6" stroke="#998877"`)];
        for (const place of Object.keys(scene.places).filter(name => !name.startsWith("start-"))) {
            const at = scene.places[place];
            parts.push(`<circle class="place" cx="${number(across(at[1]))}" cy="${number(down(at[0]))}" r="3" ` +
                `fill="#998877"><title>${escaped(place)}</title></circle>`);
        }
        Object.keys(scene.objects).forEach((name, row) => {
            const colour = COLOURS[row % COLOURS.length], object = scene.objects[name];
            if (Object.hasOwn(scene.goals, name)) {
                parts.push(box(scene.goals[name], object.size,
                    `class="goal" fill="none" stroke="${colour}" stroke-dasharray="4 3"`));
            }
        });
        Object.keys(scene.objects).forEach((name, row) => {
            const colour = COLOURS[row % COLOURS.length], object = scene.objects[name], { at, z } = state[name];
            const turn = object.turn ? ` transform="rotate(${number(-object.turn)} ${number(across(at[1]))} ` +
                `${number(down(at[0]))})"` : "";
            parts.push(box(at, object.size, `class="object" fill="${colour}" fill-opacity="${z > 0 ? 0.3 : 0.75}" ` +
                `stroke="${colour}"${turn}`));
            parts.push(words(at, name + (z > 0 ? " (held)" : ""), `fill="#000000"`));
        });
        return `<svg xmlns="http://www.w3.org/2000/svg" width="${number(width)}" height="${number(height)}" ` +
            `viewBox="0 0 ${number(width)} ${number(height)}">${parts.join("")}</svg>`;
    }

    function unknown(plan) {
        const name = plan && plan.problem ? `the problem ${plan.problem.name}` : "this plan, which has no problem";
        return `<p>neurosym knows no scene of ${escaped(name)}; run neurosym compile-domain on its folder.</p>`;
    }

    /** Returns HTML with a picture of the start and one of the state after each step. */
    function visualizePlanHtml(plan, displayWidth) {
        const scene = sceneOf(plan);
        if (!scene) { return unknown(plan); }
        const frames = framesOf(plan, scene);
        const width = frames.length > 1 ? Math.max(120, displayWidth / 2 - 8) : displayWidth;
        const figures = frames.map((frame, step) => `<figure style="display: inline-block; margin: 2px; ` +
            `width: ${Math.round(width)}px;">${drawn(scene, frame.state, width)}<figcaption>` +
            `${step ? step + ". " : ""}${escaped(frame.said)}</figcaption></figure>`);
        return `<div>${figures.join("")}</div>`;
    }

    /** Returns HTML with a picture of one state. */
    function visualizeStateHtml(plan, finalState, displayWidth) {
        const scene = sceneOf(plan);
        return scene ? drawn(scene, stateOf(scene, finalState), displayWidth) : unknown(plan);
    }

    return { visualizePlanHtml: visualizePlanHtml, visualizeStateHtml: visualizeStateHtml };
})({"cell":0.005,"problems":{"anywhere-4-19":{"goals":{"item-01":[0.4826,-0.073],"item-02":[0.7535,0.1984],"item-03":[0.457,-0.0053],"item-04":[0.4853,-0.1966]},"objects":{"item-01":{"at":[0.5242,-0.2639],"cell":[35,7],"size":[0.1604,0.0341],"turn":0.0},"item-02":{"at":[0.6136,0.1175],"cell":[53,83],"size":[0.1796,0.1796],"turn":0.0},"item-03":{"at":[0.6527,-0.1334],"cell":[61,33],"size":[0.1498,0.0462],"turn":0.0},"item-04":{"at":[0.8204,-0.1367],"cell":[94,33],"size":[0.1754,0.1754],"turn":0.0}},"places":{"goal-item-01":[0.4826,-0.0687],"goal-item-02":[0.7535,0.1984],"goal-item-03":[0.457,0.0197],"goal-item-04":[0.4853,-0.2216],"park-01":[0.8327,0.028],"park-02":[0.7796,-0.2615],"park-03":[0.5059,0.2486],"park-04":[0.6445,-0.0127],"start-item-01":[0.5242,-0.2639],"start-item-02":[0.6136,0.1175],"start-item-03":[0.6527,-0.1334],"start-item-04":[0.8204,-0.1367]}},"anywhere-8-20":{"goals":{"item-01":[0.7756,0.0077],"item-02":[0.6781,0.073],"item-03":[0.5837,-0.2407],"item-04":[0.6615,-0.087],"item-05":[0.5306,-0.0072],"item-06":[0.5689,0.1739],"item-07":[0.7529,-0.1373],"item-08":[0.8359,0.1403]},"objects":{"item-01":{"at":[0.758,0.1661],"cell":[82,93],"size":[0.0635,0.1348],"turn":0.0},"item-02":{"at":[0.5876,-0.2103],"cell":[48,18],"size":[0.0527,0.14],"turn":0.0},"item-03":{"at":[0.4841,0.0069],"cell":[27,61],"size":[0.1287,0.0397],"turn":0.0},"item-04":{"at":[0.9168,-0.0227],"cell":[113,55],"size":[0.0615,0.1669],"turn":0.0},"item-05":{"at":[0.517,0.1723],"cell":[33,94],"size":[0.1752,0.1752],"turn":0.0},"item-06":{"at":[0.766,-0.1534],"cell":[83,29],"size":[0.0874,0.1137],"turn":0.0},"item-07":{"at":[0.4498,-0.1875],"cell":[20,23],"size":[0.0877,0.1088],"turn":0.0},"item-08":{"at":[0.7656,-0.2319],"cell":[83,14],"size":[0.1119,0.0399],"turn":0.0}},"places":{"goal-item-01":[0.7756,0.0151],"goal-item-02":[0.6781,0.098],"goal-item-03":[0.5837,-0.2588],"goal-item-04":[0.6629,-0.1054],"goal-item-05":[0.5246,-0.0139],"goal-item-06":[0.5689,0.1806],"goal-item-07":[0.7576,-0.1568],"goal-item-08":[0.8359,0.1524],"park-01":[0.8825,-0.211],"park-02":[0.6721,0.2264],"park-03":[0.9022,0.2502],"park-04":[0.8283,0.2024],"park-05":[0.848,0.0052],"park-06":[0.8478,-0.086],"park-07":[0.3988,-0.0473],"park-08":[0.865,0.0939],"start-item-01":[0.758,0.1661],"start-item-02":[0.5876,-0.2103],"start-item-03":[0.4841,0.0069],"start-item-04":[0.9168,-0.0227],"start-item-05":[0.517,0.1723],"start-item-06":[0.766,-0.1534],"start-item-07":[0.4498,-0.1875],"start-item-08":[0.7656,-0.2319]}},"boxes-4-10":{"goals":{},"objects":{"item-01":{"at":[0.8599,0.1719],"cell":[102,94],"size":[0.0974,0.081],"turn":0.0},"item-02":{"at":[0.3905,0.0463],"cell":[8,69],"size":[0.048,0.16],"turn":0.0},"item-03":{"at":[0.5095,0.0001],"cell":[32,60],"size":[0.0616,0.1375],"turn":0.0},"item-04":{"at":[0.4044,0.2456],"cell":[11,109],"size":[0.1081,0.1081],"turn":0.0}},"places":{"park-01":[0.7119,-0.0921],"park-02":[0.6697,0.174],"park-03":[0.8746,-0.0598],"park-04":[0.5401,-0.1999],"start-item-01":[0.8599,0.1719],"start-item-02":[0.3905,0.0463],"start-item-03":[0.5095,0.0001],"start-item-04":[0.4044,0.2456]}},"boxes-4-11":{"goals":{},"objects":{"item-01":{"at":[0.4591,0.1533],"cell":[22,91],"size":[0.1498,0.1214],"turn":0.0},"item-02":{"at":[0.7429,0.1689],"cell":[79,94],"size":[0.1198,0.1198],"turn":0.0},"item-03":{"at":[0.6713,-0.0157],"cell":[64,57],"size":[0.1654,0.1654],"turn":0.0},"item-04":{"at":[0.9084,0.0992],"cell":[112,80],"size":[0.057,0.1668],"turn":0.0}},"places":{"park-01":[0.4553,-0.1247],"park-02":[0.7746,-0.1955],"park-03":[0.8327,0.0183],"park-04":[0.6429,0.1715],"start-item-01":[0.4591,0.1533],"start-item-02":[0.7429,0.1689],"start-item-03":[0.6713,-0.0157],"start-item-04":[0.9084,0.0992]}},"boxes-6-12":{"goals":{},"objects":{"item-01":{"at":[0.589,-0.1602],"cell":[48,28],"size":[0.1714,0.1123],"turn":0.0},"item-02":{"at":[0.8629,0.1279],"cell":[103,86],"size":[0.0519,0.1106],"turn":0.0},"item-03":{"at":[0.6504,0.0323],"cell":[60,66],"size":[0.1339,0.1339],"turn":0.0},"item-04":{"at":[0.4218,0.0743],"cell":[14,75],"size":[0.0568,0.1119],"turn":0.0},"item-05":{"at":[0.9099,-0.0869],"cell":[112,43],"size":[0.0528,0.1295],"turn":0.0},"item-06":{"at":[0.4003,0.2718],"cell":[10,114],"size":[0.0789,0.0406],"turn":0.0}},"places":{"park-01":[0.667,0.1854],"park-02":[0.7727,-0.2119],"park-03":[0.4241,-0.2165],"park-04":[0.5157,0.0552],"park-05":[0.5021,0.198],"park-06":[0.7768,-0.0012],"start-item-01":[0.589,-0.1602],"start-item-02":[0.8629,0.1279],"start-item-03":[0.6504,0.0323],"start-item-04":[0.4218,0.0743],"start-item-05":[0.9099,-0.0869],"start-item-06":[0.4003,0.2718]}},"boxes-6-13":{"goals":{},"objects":{"item-01":{"at":[0.8839,0.0438],"cell":[107,69],"size":[0.1169,0.0367],"turn":0.0},"item-02":{"at":[0.6189,-0.1796],"cell":[54,24],"size":[0.1352,0.1352],"turn":0.0},"item-03":{"at":[0.4733,0.1381],"cell":[25,88],"size":[0.0541,0.1521],"turn":0.0},"item-04":{"at":[0.7326,0.2103],"cell":[77,102],"size":[0.1703,0.099],"turn":0.0},"item-05":{"at":[0.7487,0.0401],"cell":[80,68],"size":[0.0393,0.1181],"turn":0.0},"item-06":{"at":[0.8753,-0.0706],"cell":[105,46],"size":[0.0602,0.1059],"turn":0.0}},"places":{"park-01":[0.6203,0.0352],"park-02":[0.4553,-0.1868],"park-03":[0.7989,-0.2228],"park-04":[0.8844,0.2154],"park-05":[0.78,-0.0856],"park-06":[0.5766,0.2217],"start-item-01":[0.8839,0.0438],"start-item-02":[0.6189,-0.1796],"start-item-03":[0.4733,0.1381],"start-item-04":[0.7326,0.2103],"start-item-05":[0.7487,0.0401],"start-item-06":[0.8753,-0.0706]}},"exchange-4-17":{"goals":{},"objects":{"item-01":{"at":[0.714,-0.0922],"cell":[73,42],"size":[0.1585,0.1585],"turn":4.5},"item-02":{"at":[0.5273,0.1707],"cell":[35,94],"size":[0.1585,0.1783],"turn":0.0},"item-03":{"at":[0.7106,-0.111],"cell":[72,38],"size":[0.1793,0.1428],"turn":0.0},"item-04":{"at":[0.5237,0.2169],"cell":[35,103],"size":[0.1555,0.1165],"turn":-0.4}},"places":{"park-01":[0.4753,-0.1845],"park-02":[0.7693,0.1575],"park-03":[0.4541,-0.007],"start-item-01":[0.714,-0.0922],"start-item-02":[0.5273,0.1707],"start-item-03":[0.7106,-0.111],"start-item-04":[0.5237,0.2169]}},"exchange-6-18":{"goals":{},"objects":{"item-01":{"at":[0.4998,0.2374],"cell":[30,107],"size":[0.1151,0.1151],"turn":-0.4},"item-02":{"at":[0.882,-0.1634],"cell":[106,27],"size":[0.0354,0.1737],"turn":-1.0},"item-03":{"at":[0.4898,0.2371],"cell":[28,107],"size":[0.0951,0.1091],"turn":-0.1},"item-04":{"at":[0.6857,0.1135],"cell":[67,83],"size":[0.1499,0.152],"turn":0.0},"item-05":{"at":[0.8783,-0.1931],"cell":[106,21],"size":[0.1074,0.1074],"turn":0.0},"item-06":{"at":[0.7682,-0.0309],"cell":[84,54],"size":[0.1766,0.0409],"turn":0.0}},"places":{"park-01":[0.474,-0.1868],"park-02":[0.4593,0.0392],"park-03":[0.6939,-0.1822],"park-04":[0.8731,0.2154],"park-05":[0.8617,0.0767],"park-06":[0.6729,0.2259],"start-item-01":[0.4998,0.2374],"start-item-02":[0.882,-0.1634],"start-item-03":[0.4898,0.2371],"start-item-04":[0.6857,0.1135],"start-item-05":[0.8783,-0.1931],"start-item-06":[0.7682,-0.0309]}},"tower-2-01":{"goals":{},"objects":{"item-01":{"at":[0.776,-0.1344],"cell":[85,33],"size":[0.1354,0.1354],"turn":0.0},"item-02":{"at":[0.5873,-0.1468],"cell":[47,31],"size":[0.0692,0.1758],"turn":0.0}},"places":{"park-01":[0.783,0.1586],"park-02":[0.4951,0.0851],"start-item-01":[0.776,-0.1344],"start-item-02":[0.5873,-0.1468]}},"tower-2-02":{"goals":{},"objects":{"item-01":{"at":[0.5807,0.0146],"cell":[46,63],"size":[0.1369,0.1369],"turn":0.0},"item-02":{"at":[0.6734,-0.1794],"cell":[65,24],"size":[0.1731,0.1618],"turn":0.0}},"places":{"park-01":[0.8423,0.1915],"park-02":[0.4724,-0.1925],"start-item-01":[0.5807,0.0146],"start-item-02":[0.6734,-0.1794]}},"tower-4-03":{"goals":{},"objects":{"item-01":{"at":[0.4745,-0.2064],"cell":[25,19],"size":[0.1123,0.0504],"turn":0.0},"item-02":{"at":[0.7462,0.1345],"cell":[79,87],"size":[0.037,0.1382],"turn":0.0},"item-03":{"at":[0.5186,0.1579],"cell":[34,92],"size":[0.156,0.0581],"turn":0.0},"item-04":{"at":[0.7302,-0.1193],"cell":[76,36],"size":[0.1782,0.1782],"turn":0.0}},"places":{"park-01":[0.4926,-0.0401],"park-02":[0.8618,0.2221],"park-03":[0.8553,0.033],"park-04":[0.6728,0.2217],"start-item-01":[0.4745,-0.2064],"start-item-02":[0.7462,0.1345],"start-item-03":[0.5186,0.1579],"start-item-04":[0.7302,-0.1193]}},"tower-4-04":{"goals":{},"objects":{"item-01":{"at":[0.7987,-0.1669],"cell":[90,27],"size":[0.1428,0.1428],"turn":0.0},"item-02":{"at":[0.4696,0.1682],"cell":[24,94],"size":[0.045,0.1726],"turn":0.0},"item-03":{"at":[0.8489,0.1625],"cell":[100,92],"size":[0.1242,0.1738],"turn":0.0},"item-04":{"at":[0.5847,-0.259],"cell":[47,8],"size":[0.107,0.0771],"turn":0.0}},"places":{"park-01":[0.6441,0.1504],"park-02":[0.4934,-0.0817],"park-03":[0.65,-0.0301],"park-04":[0.4136,-0.2335],"start-item-01":[0.7987,-0.1669],"start-item-02":[0.4696,0.1682],"start-item-03":[0.8489,0.1625],"start-item-04":[0.5847,-0.259]}},"tower-6-05":{"goals":{},"objects":{"item-01":{"at":[0.5766,0.1723],"cell":[45,94],"size":[0.0493,0.0613],"turn":0.0},"item-02":{"at":[0.9226,0.068],"cell":[115,74],"size":[0.0472,0.1292],"turn":0.0},"item-03":{"at":[0.6254,-0.0974],"cell":[55,41],"size":[0.1306,0.1306],"turn":0.0},"item-04":{"at":[0.8627,-0.1465],"cell":[103,31],"size":[0.0523,0.1091],"turn":0.0},"item-05":{"at":[0.7235,0.1864],"cell":[75,97],"size":[0.0518,0.1076],"turn":0.0},"item-06":{"at":[0.4301,0.2069],"cell":[16,101],"size":[0.1323,0.1323],"turn":0.0}},"places":{"park-01":[0.4404,-0.0577],"park-02":[0.4537,-0.2068],"park-03":[0.8053,0.0177],"park-04":[0.6132,0.0488],"park-05":[0.8529,0.2088],"park-06":[0.7667,-0.143],"start-item-01":[0.5766,0.1723],"start-item-02":[0.9226,0.068],"start-item-03":[0.6254,-0.0974],"start-item-04":[0.8627,-0.1465],"start-item-05":[0.7235,0.1864],"start-item-06":[0.4301,0.2069]}},"tower-6-06":{"goals":{},"objects":{"item-01":{"at":[0.5856,-0.1929],"cell":[47,21],"size":[0.1027,0.1183],"turn":0.0},"item-02":{"at":[0.6978,0.2004],"cell":[70,100],"size":[0.1532,0.1317],"turn":0.0},"item-03":{"at":[0.4764,0.1829],"cell":[25,97],"size":[0.0305,0.114],"turn":0.0},"item-04":{"at":[0.4538,-0.2415],"cell":[21,12],"size":[0.0347,0.1124],"turn":0.0},"item-05":{"at":[0.8201,-0.0516],"cell":[94,50],"size":[0.0878,0.1079],"turn":0.0},"item-06":{"at":[0.8975,-0.2177],"cell":[109,16],"size":[0.0574,0.1083],"turn":0.0}},"places":{"park-01":[0.6058,-0.0142],"park-02":[0.7785,-0.213],"park-03":[0.8923,0.2148],"park-04":[0.4505,0.0359],"park-05":[0.4135,0.1625],"park-06":[0.467,-0.0946],"start-item-01":[0.5856,-0.1929],"start-item-02":[0.6978,0.2004],"start-item-03":[0.4764,0.1829],"start-item-04":[0.4538,-0.2415],"start-item-05":[0.8201,-0.0516],"start-item-06":[0.8975,-0.2177]}},"tower-6-07":{"goals":{},"objects":{"item-01":{"at":[0.4917,-0.1641],"cell":[28,27],"size":[0.1352,0.046],"turn":0.0},"item-02":{"at":[0.7132,-0.0039],"cell":[73,59],"size":[0.0639,0.1445],"turn":0.0},"item-03":{"at":[0.8698,0.0229],"cell":[104,65],"size":[0.0872,0.1738],"turn":0.0},"item-04":{"at":[0.7766,0.2651],"cell":[85,113],"size":[0.1351,0.0634],"turn":0.0},"item-05":{"at":[0.8567,-0.1816],"cell":[101,24],"size":[0.1196,0.117],"turn":0.0},"item-06":{"at":[0.4696,0.0199],"cell":[24,64],"size":[0.1746,0.1746],"turn":0.0}},"places":{"park-01":[0.6941,-0.1818],"park-02":[0.52,0.1898],"park-03":[0.6635,0.1465],"park-04":[0.4223,-0.2485],"park-05":[0.8967,0.2472],"park-06":[0.5164,-0.2303],"start-item-01":[0.4917,-0.1641],"start-item-02":[0.7132,-0.0039],"start-item-03":[0.8698,0.0229],"start-item-04":[0.7766,0.2651],"start-item-05":[0.8567,-0.1816],"start-item-06":[0.4696,0.0199]}},"tower-6-08":{"goals":{},"objects":{"item-01":{"at":[0.6274,0.2798],"cell":[55,116],"size":[0.125,0.0333],"turn":0.0},"item-02":{"at":[0.8687,0.1817],"cell":[104,96],"size":[0.1376,0.1376],"turn":0.0},"item-03":{"at":[0.7004,-0.1667],"cell":[70,27],"size":[0.1351,0.1351],"turn":0.0},"item-04":{"at":[0.9141,-0.0511],"cell":[113,50],"size":[0.0687,0.1346],"turn":0.0},"item-05":{"at":[0.4583,-0.1931],"cell":[22,21],"size":[0.116,0.116],"turn":0.0},"item-06":{"at":[0.5245,0.06],"cell":[35,72],"size":[0.1743,0.1743],"turn":0.0}},"places":{"park-01":[0.7494,-0.001],"park-02":[0.7055,0.1816],"park-03":[0.8435,-0.1996],"park-04":[0.4456,0.1752],"park-05":[0.5695,-0.1842],"park-06":[0.5024,0.2329],"start-item-01":[0.6274,0.2798],"start-item-02":[0.8687,0.1817],"start-item-03":[0.7004,-0.1667],"start-item-04":[0.9141,-0.0511],"start-item-05":[0.4583,-0.1931],"start-item-06":[0.5245,0.06]}},"tower-8-09":{"goals":{},"objects":{"item-01":{"at":[0.8479,-0.1857],"cell":[100,23],"size":[0.1301,0.0578],"turn":0.0},"item-02":{"at":[0.4403,-0.1828],"cell":[18,23],"size":[0.1312,0.1312],"turn":0.0},"item-03":{"at":[0.8955,0.2508],"cell":[109,110],"size":[0.0603,0.081],"turn":0.0},"item-04":{"at":[0.7825,0.0152],"cell":[87,63],"size":[0.1342,0.1342],"turn":0.0},"item-05":{"at":[0.4417,0.0589],"cell":[18,72],"size":[0.0561,0.1242],"turn":0.0},"item-06":{"at":[0.5944,0.1222],"cell":[49,84],"size":[0.1533,0.1533],"turn":0.0},"item-07":{"at":[0.8247,-0.2765],"cell":[95,5],"size":[0.1591,0.0335],"turn":0.0},"item-08":{"at":[0.623,-0.184],"cell":[55,23],"size":[0.1256,0.1445],"turn":0.0}},"places":{"park-01":[0.771,0.1723],"park-02":[0.564,-0.0334],"park-03":[0.4424,0.2015],"park-04":[0.62,0.2393],"park-05":[0.4031,-0.071],"park-06":[0.7889,-0.1006],"park-07":[0.8928,0.0376],"park-08":[0.7369,-0.1605],"start-item-01":[0.8479,-0.1857],"start-item-02":[0.4403,-0.1828],"start-item-03":[0.8955,0.2508],"start-item-04":[0.7825,0.0152],"start-item-05":[0.4417,0.0589],"start-item-06":[0.5944,0.1222],"start-item-07":[0.8247,-0.2765],"start-item-08":[0.623,-0.184]}},"unstack-5-14":{"goals":{},"objects":{"item-01":{"at":[0.7164,0.055],"cell":[73,71],"size":[0.1184,0.1184],"turn":0.0},"item-02":{"at":[0.7725,-0.1955],"cell":[84,21],"size":[0.1638,0.062],"turn":0.1},"item-03":{"at":[0.5345,-0.0164],"cell":[37,57],"size":[0.0588,0.1481],"turn":0.0},"item-04":{"at":[0.7686,-0.2073],"cell":[84,19],"size":[0.1014,0.0425],"turn":-0.1},"item-05":{"at":[0.7726,-0.2012],"cell":[85,20],"size":[0.0348,0.0317],"turn":-0.3}},"places":{"park-01":[0.5109,0.1947],"park-02":[0.4681,-0.1992],"park-03":[0.6976,0.2039],"park-04":[0.7128,-0.1147],"park-05":[0.878,0.2395],"start-item-01":[0.7164,0.055],"start-item-02":[0.7725,-0.1955],"start-item-03":[0.5345,-0.0164],"start-item-04":[0.7686,-0.2073],"start-item-05":[0.7726,-0.2012]}},"unstack-5-15":{"goals":{},"objects":{"item-01":{"at":[0.7545,0.0139],"cell":[81,63],"size":[0.1771,0.1202],"turn":0.2},"item-02":{"at":[0.7467,0.0215],"cell":[79,64],"size":[0.1558,0.1558],"turn":0.0},"item-03":{"at":[0.472,-0.1156],"cell":[24,37],"size":[0.1484,0.0921],"turn":0.0},"item-04":{"at":[0.392,0.2201],"cell":[8,104],"size":[0.0494,0.1563],"turn":0.0},"item-05":{"at":[0.8112,-0.0164],"cell":[92,57],"size":[0.0643,0.1244],"turn":0.5}},"places":{"park-01":[0.771,-0.2007],"park-02":[0.8404,0.1941],"park-03":[0.5455,0.0497],"park-04":[0.5054,0.2059],"park-05":[0.4156,-0.2262],"start-item-01":[0.7545,0.0139],"start-item-02":[0.7467,0.0215],"start-item-03":[0.472,-0.1156],"start-item-04":[0.392,0.2201],"start-item-05":[0.8112,-0.0164]}},"unstack-6-16":{"goals":{},"objects":{"item-01":{"at":[0.8473,0.2461],"cell":[99,109],"size":[0.1237,0.0878],"turn":0.0},"item-02":{"at":[0.4018,-0.1861],"cell":[10,23],"size":[0.0662,0.1171],"turn":0.0},"item-03":{"at":[0.5692,-0.0737],"cell":[44,45],"size":[0.0382,0.123],"turn":0.0},"item-04":{"at":[0.7311,-0.0212],"cell":[76,56],"size":[0.1429,0.1429],"turn":0.0},"item-05":{"at":[0.7871,-0.0516],"cell":[87,50],"size":[0.0628,0.1101],"turn":0.2},"item-06":{"at":[0.7817,-0.05],"cell":[86,50],"size":[0.1315,0.1163],"turn":0.2}},"places":{"park-01":[0.4765,0.1387],"park-02":[0.6682,0.1815],"park-03":[0.7817,-0.2074],"park-04":[0.4434,-0.0379],"park-05":[0.8797,0.1247],"park-06":[0.6067,-0.2215],"start-item-01":[0.8473,0.2461],"start-item-02":[0.4018,-0.1861],"start-item-03":[0.5692,-0.0737],"start-item-04":[0.7311,-0.0212],"start-item-05":[0.7871,-0.0516],"start-item-06":[0.7817,-0.05]}}},"table":{"x":[0.35,0.95],"y":[-0.3,0.3]}});
