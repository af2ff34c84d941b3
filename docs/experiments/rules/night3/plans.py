import re,sys
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import *
for n in ('showroom','campsite'):
    s=Scene(n+'.3500')
    def put(name,p):
        write(p,'p_%s_%s'%(n,name)); print(n,name,'windows',len(p),'walks',sum(len(v) for v in p.values()),sorted(p))
    four=lambda ws: {w:['F%d'%i for i in range(4) if s.get(w,'F',i) is not None] for w in ws}
    for k,c in (('r',5632),('r',8000),('w',9733),('w',12000),('c',8073),('c',10000),('a',60000),('a',90000),('g',16864),('g',22576)):
        put('%s%d'%(k,c),rule(s,k,c))
    for k,c in (('r',5632),('w',9733),('c',8073)): put('%s%dh'%(k,c),rule(s,k,c,halves=True))
    put('r5632s',rule(s,'r',5632,small=True))
    for v in ('base','m','q','qm'):
        try: ws=sorted({int(x) for x in re.findall(r'^spill .* window (\d+)',open('%s_%s.err'%(n,v)).read(),re.M)})
        except Exception: continue
        put('spill_'+v,four(ws))
    # reactive: whole until the first bucket at which what waits (c: Gaussians of chunks) is over the cap, then parts
    for k,c in (('r',5632),('c',8073)):
        p={}
        for w in s.windows:
            i=s.get(w,'W'); pr=s.prof[k][i]
            over=np.nonzero(pr>c)[0]
            if not len(over): continue
            b=int(over[0])
            f=[x for x in range(4) if s.get(w,'F',x) is not None]
            if not f: continue
            p[w]=['W0:0:%d'%b]+['F%d:%d:%d'%(x,b,s.nb) for x in f]
        put('x%s%d'%(k,c),p)
