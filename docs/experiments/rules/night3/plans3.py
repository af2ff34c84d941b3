import sys
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import *
from importlib import reload
def prof(s,step,mode):
    g=s.grp; nb=(s.nb>>step)+1
    f=g[:,4]/256; v=g[:,3]*{'w':f,'g':np.ones_like(f),'q':np.ceil(f*4)/4,'h':np.where(f>=.5,1.0,0.25)}[mode]
    d=np.zeros((len(s.walks),nb+1))
    np.add.at(d,(g[:,0],g[:,1]>>step),v); np.add.at(d,(g[:,0],np.maximum(g[:,1],g[:,2])//(1<<step)+1),-v)
    return d.cumsum(1).max(1)
todo=[]
K="X_QUEUE=128 X_HALVES=8 X_LOG=1 RECORDS=1408 X_OCC=2 X_EPISODE=1 X_MSHIFT=4 X_PACE=4"
for n in ('showroom','campsite'):
    s=Scene(n+'.3500')
    have=lambda w,v: [v+str(p) for p in range(4) if s.get(w,v,p) is not None]
    need={w for w in s.windows if s.peak['r'][s.get(w,'W')]>5632}
    def put(name,p):
        write(p,'p_%s_%s'%(n,name))
        print(n,name,'windows',len(p),'walks',sum(len(v) for v in p.values()),'missed',sorted(need-set(p)),'extra',sorted(set(p)-need))
        todo.append(f"{n} {n}_d4_{name} {K} PLAN=p_{n}_{name}")
    def fits(pk,cap,two=True,small=False):
        out={}
        for w in s.windows:
            if pk[s.get(w,'W')]<=cap or not have(w,'F'): continue
            m,v=min((max(pk[s.get(w,v,p)] for p in (0,1) if s.get(w,v,p) is not None),v) for v in 'HV')
            if two and m<=cap: out[w]=have(w,v); continue
            o=[]
            for p in range(4):
                i=s.get(w,'F',p)
                if i is None: continue
                q=['S%d'%(4*p+k) for k in range(4) if s.get(w,'S',4*p+k) is not None]
                o+=q if small and pk[i]>cap and q else ['F%d'%p]
            out[w]=o
        return out
    W=s.peak['w']
    put('w97h',fits(W,9733)); put('w97hs',fits(W,9733,True,True))
    put('w85h',fits(W,8500)); put('w85hs',fits(W,8500,True,True)); put('w7h',fits(W,7000))
    w2=prof(s,2,'w'); put('w2_12h',fits(w2,12000)); put('w2_10h',fits(w2,10000)); put('w2_12f',fits(w2,12000,False))
    g2=prof(s,2,'g'); put('g2_26f',fits(g2,26000,False)); put('g2_22f',fits(g2,22000,False)); put('g2_22h',fits(g2,22000))
    q2=prof(s,2,'q'); put('q2_14h',fits(q2,14500)); 
    put('r56hs',fits(s.peak['r'],5632,True,True))
    put('r48hs',fits(s.peak['r'],4800,True,True))
open('todo2','a').write('\n'.join(todo)+'\n')
