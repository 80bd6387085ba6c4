; Problem task-01 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 2: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-01)
  (:domain tabletop-numeric)
  (:objects
    item-01 - solid-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6312, -0.0864, 0.0432) m
    (= (x item-01) 2812) (= (y item-01) 2136) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.06355 0.1761 0.08649 0).
    ; Not for item-01:
    ; lift-1100-solid-00: keeps its promise in 1 of 32 rehearsals only.
    ; pull-left-0101-solid-00: scatters more than it moves.
    ; pull-left-1101-solid-00: scatters more than it moves.
    ; pull-right-1010a-solid-00: moves less than half a cell.
    ; push-left-1110a-solid-00: scatters more than it moves.
    ; push-right-1000-solid-00: scatters more than it moves.
    (= (x-of-lift-1100-solid-00 item-01) 9744) (= (y-of-lift-1100-solid-00 item-01) 10152) (= (z-of-lift-1100-solid-00 item-01) 12024) (= (cost-of-lift-1100-solid-00 item-01) 284)
    (= (x-of-put-down-lift-1100-solid-00 item-01) 9997) (= (y-of-put-down-lift-1100-solid-00 item-01) 9991) (= (z-of-put-down-lift-1100-solid-00 item-01) 7976)
    (can-pull-0100a-solid-00 item-01) (= (x-of-pull-0100a-solid-00 item-01) 9336) (= (y-of-pull-0100a-solid-00 item-01) 9611) (= (cost-of-pull-0100a-solid-00 item-01) 14)
    (can-pull-0110a-solid-00 item-01) (= (x-of-pull-0110a-solid-00 item-01) 9737) (= (y-of-pull-0110a-solid-00 item-01) 9938) (= (cost-of-pull-0110a-solid-00 item-01) 4)
    (can-pull-0111a-solid-00 item-01) (= (x-of-pull-0111a-solid-00 item-01) 9388) (= (y-of-pull-0111a-solid-00 item-01) 10128) (= (cost-of-pull-0111a-solid-00 item-01) 4)
    (= (x-of-pull-left-0101-solid-00 item-01) 9911) (= (y-of-pull-left-0101-solid-00 item-01) 10142) (= (cost-of-pull-left-0101-solid-00 item-01) 10)
    (= (x-of-pull-left-1101-solid-00 item-01) 9972) (= (y-of-pull-left-1101-solid-00 item-01) 9979) (= (cost-of-pull-left-1101-solid-00 item-01) 10)
    (can-pull-left-1111a-solid-00 item-01) (= (x-of-pull-left-1111a-solid-00 item-01) 9832) (= (y-of-pull-left-1111a-solid-00 item-01) 10153) (= (cost-of-pull-left-1111a-solid-00 item-01) 4)
    (can-pull-right-0000a-solid-00 item-01) (= (x-of-pull-right-0000a-solid-00 item-01) 9696) (= (y-of-pull-right-0000a-solid-00 item-01) 9447) (= (cost-of-pull-right-0000a-solid-00 item-01) 97)
    (= (x-of-pull-right-1010a-solid-00 item-01) 9979) (= (y-of-pull-right-1010a-solid-00 item-01) 9995) (= (cost-of-pull-right-1010a-solid-00 item-01) 4)
    (can-push-forward-1011-solid-00 item-01) (= (x-of-push-forward-1011-solid-00 item-01) 10627) (= (y-of-push-forward-1011-solid-00 item-01) 10092) (= (cost-of-push-forward-1011-solid-00 item-01) 17)
    (can-push-forward-1011a-solid-00 item-01) (= (x-of-push-forward-1011a-solid-00 item-01) 10714) (= (y-of-push-forward-1011a-solid-00 item-01) 9855) (= (cost-of-push-forward-1011a-solid-00 item-01) 14)
    (can-push-forward-left-0001a-solid-00 item-01) (= (x-of-push-forward-left-0001a-solid-00 item-01) 10150) (= (y-of-push-forward-left-0001a-solid-00 item-01) 10131) (= (cost-of-push-forward-left-0001a-solid-00 item-01) 7)
    (can-push-forward-left-1001-solid-00 item-01) (= (x-of-push-forward-left-1001-solid-00 item-01) 10107) (= (y-of-push-forward-left-1001-solid-00 item-01) 10128) (= (cost-of-push-forward-left-1001-solid-00 item-01) 4)
    (can-push-forward-right-0010a-solid-00 item-01) (= (x-of-push-forward-right-0010a-solid-00 item-01) 10186) (= (y-of-push-forward-right-0010a-solid-00 item-01) 9727) (= (cost-of-push-forward-right-0010a-solid-00 item-01) 4)
    (can-push-left-0011a-solid-00 item-01) (= (x-of-push-left-0011a-solid-00 item-01) 10110) (= (y-of-push-left-0011a-solid-00 item-01) 10503) (= (cost-of-push-left-0011a-solid-00 item-01) 4)
    (= (x-of-push-left-1110a-solid-00 item-01) 9962) (= (y-of-push-left-1110a-solid-00 item-01) 10134) (= (cost-of-push-left-1110a-solid-00 item-01) 4)
    (= (x-of-push-right-1000-solid-00 item-01) 9994) (= (y-of-push-right-1000-solid-00 item-01) 9801) (= (cost-of-push-right-1000-solid-00 item-01) 4)
    (can-push-right-1100-solid-00 item-01) (= (x-of-push-right-1100-solid-00 item-01) 9999) (= (y-of-push-right-1100-solid-00 item-01) 9486) (= (cost-of-push-right-1100-solid-00 item-01) 10))
  (:goal (and
    ; item-01 shall come to (0.6877, -0.0637, 0.0432) m, 61 mm from where it starts
    (<= (x item-01) 3832) (>= (x item-01) 2923)
    (<= (+ (x item-01) (y item-01)) 6385) (>= (+ (x item-01) (y item-01)) 5097)
    (<= (y item-01) 2818) (>= (y item-01) 1909)
    (<= (+ (y item-01) 371) (x item-01)) (<= (x item-01) (+ (y item-01) 1658))
    (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
