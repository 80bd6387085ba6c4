// Draws the states of a plan from above, for the extension "PDDL" of Visual Studio Code. Written by neurosym;
// do not edit: compile-domain and new-problem write it again, with the scenes of all problems of the folder.
// Below stands the robot, x leads away from it, and y to its left.
module.exports = (function (data) {
    "use strict";
    const MARGIN = 0.03, NOTES = new Set(["note-clear", "leave", "reach-cell", "reach-lifted", "reach-place"]);
    const PARTS = new Set(["move-x", "move-y"]), TAKES = new Set(["take", "take-off"]);
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
            state[name] = { at: scene.objects[name].at.slice(), held: false, on: null };
        }
        for (const led of [false, true]) { // cells say more than the place where something started
            for (const fact of facts) {
                const words = fact.variableName.toLowerCase().split(" ");
                if (fact.value === false || words.length !== 3 || !state[words[1]]) { continue; }
                if (!led && words[0] === "stands") { moveToPlace(state, scene, words[1], words[2]); }
                if (!led && words[0] === "lifted") { state[words[1]].held = true; }
                if (led && /^at-[xy]$/.test(words[0])) { moveToCell(state, scene, words[1], words[2]); }
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

    /** Returns the object that a perch is on or in, by the end of its name, or undefined. */
    function bearerOf(scene, place) {
        return Object.keys(scene.objects).find(name => place.endsWith("-" + name));
    }

    function moveToPlace(state, scene, name, place) {
        const at = placeNamed(scene, place), bearer = at ? null : bearerOf(scene, place);
        if (at) { state[name] = { at: at, held: false, on: null }; }
        if (bearer && bearer !== name) { state[name] = { at: state[name].at, held: false, on: bearer }; }
        return Boolean(at || bearer);
    }

    /** Moves an object along an axis, as far from where it started as its cell is from the one it started in. */
    function moveToCell(state, scene, name, cell) {
        const axis = "xy".indexOf(cell[0]), object = scene.objects[name];
        state[name].at[axis] = object.at[axis] + (Number(cell.slice(1)) - object.cell[axis]) * scene.cell;
    }

    /** Does a step of a plan; returns what to write below the picture, or "" if it belongs to the step before. */
    function act(state, scene, words) {
        const name = words.slice(1).find(word => Object.hasOwn(scene.objects, word));
        if (name === undefined || NOTES.has(words[0]) || TAKES.has(words[0])) { return ""; }
        const after = words.slice(words.indexOf(name) + 1);
        for (const place of [after[1], after[0]]) { // from one place to another, or only where to
            if (place !== undefined && moveToPlace(state, scene, name, place)) {
                return [words[0], name, place].join(" ");
            }
        }
        state[name].held = words[0] === "lift" || state[name].held && words[0] !== "put-down";
        for (const word of words) {
            if (/^[xy]\d+$/.test(word)) { moveToCell(state, scene, name, word); }
        }
        return PARTS.has(words[0]) ? "" : [words[0], name, ...after.filter(word => word.startsWith("m-"))].join(" ");
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

    /** Returns the objects with how many bear each, those that bear before what they bear. */
    function stacked(state) {
        const depth = name => {
            let found = 0;
            for (let below = state[name].on; below && found < 99; below = state[below].on) { found += 1; }
            return found;
        };
        return Object.keys(state).map((name, row) => ({ name, row, depth: depth(name) }))
            .sort((one, other) => one.depth - other.depth || one.row - other.row);
    }

    /** Returns where an object is seen from above: over what bears it. */
    function spotOf(state, name) {
        let below = name;
        for (let count = 0; state[below].on && count < 99; count += 1) { below = state[below].on; }
        return state[below].at;
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
        for (const { name, row, depth } of stacked(state)) {
            const colour = COLOURS[row % COLOURS.length], object = scene.objects[name], held = state[name].held;
            const at = spotOf(state, name), where = `${number(across(at[1]))} ${number(down(at[0]))}`;
            const turn = object.turn ? ` transform="rotate(${number(-object.turn)} ${where})"` : "";
            parts.push(box(at, object.size, `class="object" fill="${colour}" fill-opacity="${held ? 0.3 : 0.75}" ` +
                `stroke="${colour}"${turn}`));
            const line = [at[0] - depth * width / 24 / scale, at[1]]; // one below the other
            parts.push(words(line, name + (held ? " (held)" : ""), `fill="#000000"`));
        }
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
})(/* scenes */ {});
